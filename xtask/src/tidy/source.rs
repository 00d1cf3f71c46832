//! What tidy wants to know about one Rust file; `syn` reads it, so strings and comments cannot mislead.

use std::path::Path;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};

/// Macros that must not survive.
const LEFTOVERS: &[&str] = &["todo", "dbg", "unimplemented"];

/// The facts about one file.
pub struct SourceFile {
    /// Relative to the workspace root, with forward slashes.
    pub path: String,
    /// All lines, blank ones and tests included.
    pub lines: usize,
    /// Every function and method, nested ones too.
    pub functions: Vec<Function>,
    /// Does it begin with `//!`?
    pub has_heading: bool,
    /// Line and name of each forbidden macro.
    pub leftovers: Vec<(usize, String)>,
}

/// One function's place and size.
pub struct Function {
    /// Its bare name.
    pub name: String,
    /// Line of its `fn`.
    pub first_line: usize,
    /// From the signature to the closing brace.
    pub lines: usize,
}

impl SourceFile {
    /// Reads and measures a file.
    pub fn read(root: &Path, path: &Path) -> Result<Self, String> {
        let shown = path.strip_prefix(root).unwrap_or(path).to_string_lossy().replace('\\', "/");
        let text = std::fs::read_to_string(path).map_err(|e| format!("{shown}: {e}"))?;
        Self::measure(shown, &text)
    }

    fn measure(path: String, text: &str) -> Result<Self, String> {
        let tree = syn::parse_file(text).map_err(|e| format!("{path}:{}: {e}", e.span().start().line))?;
        let mut survey = Survey::default();
        survey.visit_file(&tree);
        Ok(SourceFile {
            path,
            lines: text.lines().count(),
            functions: survey.functions,
            has_heading: text.starts_with("//!"),
            leftovers: survey.leftovers,
        })
    }
}

#[derive(Default)]
struct Survey {
    functions: Vec<Function>,
    leftovers: Vec<(usize, String)>,
}

impl Survey {
    fn note(&mut self, signature: &syn::Signature, block: &syn::Block) {
        let first_line = signature.span().start().line;
        let lines = block.span().end().line + 1 - first_line;
        self.functions.push(Function { name: signature.ident.to_string(), first_line, lines });
    }
}

impl<'a> Visit<'a> for Survey {
    fn visit_item_fn(&mut self, f: &'a syn::ItemFn) {
        self.note(&f.sig, &f.block);
        visit::visit_item_fn(self, f);
    }

    fn visit_impl_item_fn(&mut self, f: &'a syn::ImplItemFn) {
        self.note(&f.sig, &f.block);
        visit::visit_impl_item_fn(self, f);
    }

    fn visit_trait_item_fn(&mut self, f: &'a syn::TraitItemFn) {
        if let Some(block) = &f.default {
            self.note(&f.sig, block);
        }
        visit::visit_trait_item_fn(self, f);
    }

    fn visit_macro(&mut self, m: &'a syn::Macro) {
        if let Some(name) = m.path.segments.last().map(|s| s.ident.to_string())
            && LEFTOVERS.contains(&name.as_str())
        {
            self.leftovers.push((m.span().start().line, name));
        }
        visit::visit_macro(self, m);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_headings_and_leftovers_are_seen() {
        let text =
            "//! Room.\nfn a() {\n    let _s = \"} todo!()\";\n}\nimpl X {\n    fn b() { todo!() }\n}\n";
        let file = SourceFile::measure("x.rs".into(), text).expect("parses");
        let sizes: Vec<_> = file.functions.iter().map(|f| (f.name.as_str(), f.first_line, f.lines)).collect();
        assert_eq!(sizes, [("a", 2, 3), ("b", 6, 1)]);
        assert!(file.has_heading);
        assert_eq!(file.leftovers, [(6, "todo".to_string())]);
        assert_eq!(file.lines, 7);
    }

    #[test]
    fn a_file_that_does_not_parse_is_named_with_its_line() {
        let Err(message) = SourceFile::measure("x.rs".into(), "//! Room.\nfn (") else { panic!("parsed") };
        assert!(message.starts_with("x.rs:2:"), "{message}");
    }
}
