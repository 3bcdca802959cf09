//! The statements of an OBJ file: what a line says, with lines that go on in the next one, without comments.

/// A keyword and the words behind it.
pub struct Statement<'a> {
    /// The number of the line that it begins in.
    pub line: usize,
    pub keyword: &'a [u8],
    rest: &'a [u8],
}

impl<'a> Statement<'a> {
    /// Between blanks, and between a `\` and the line that goes on.
    pub fn words(&self) -> impl Iterator<Item = &'a [u8]> {
        let is_gap = |byte: &u8| byte.is_ascii_whitespace() || *byte == b'\\';
        self.rest.split(is_gap).filter(|word| !word.is_empty())
    }

    /// Its words as messages show them.
    pub fn shown(&self) -> String {
        super::shown(self.rest)
    }
}

/// All statements of a file. Lines end in LF, CR or both, in any mixture.
pub fn statements(bytes: &[u8]) -> Statements<'_> {
    Statements { bytes, line: 1 }
}

pub struct Statements<'a> {
    /// From the start of a line on.
    bytes: &'a [u8],
    line: usize,
}

impl<'a> Iterator for Statements<'a> {
    type Item = Statement<'a>;

    fn next(&mut self) -> Option<Statement<'a>> {
        while !self.bytes.is_empty() {
            let line = self.line;
            let text = self.take().trim_ascii();
            if !text.is_empty() {
                let end = text.iter().position(u8::is_ascii_whitespace).unwrap_or(text.len());
                return Some(Statement { line, keyword: &text[..end], rest: text[end..].trim_ascii() });
            }
        }
        None
    }
}

impl<'a> Statements<'a> {
    /// The text of a line and of those that it goes on in; goes behind them.
    fn take(&mut self) -> &'a [u8] {
        let all = self.bytes;
        let mut at = 0;
        loop {
            let rest = &all[at..];
            let end = rest.iter().position(|b| matches!(b, b'\n' | b'\r' | b'#')).unwrap_or(rest.len());
            let text = &all[..at + end];
            let comment = &rest[end..];
            let ends = comment.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(comment.len());
            let is_crlf = comment[ends..].starts_with(b"\r\n");
            let next = at + end + ends + if is_crlf { 2 } else { usize::from(ends < comment.len()) };
            self.line += 1;
            self.bytes = &all[next..];
            // A comment or a name may end in a backslash, too. So only numbers go on.
            let goes_on =
                ends == 0 && text.trim_ascii_end().ends_with(b"\\") && begins_with_number(self.bytes);
            if !goes_on {
                return text;
            }
            at = next;
        }
    }
}

fn begins_with_number(line: &[u8]) -> bool {
    let first = line.iter().find(|byte| !matches!(byte, b' ' | b'\t'));
    first.is_some_and(|byte| byte.is_ascii_digit() || matches!(byte, b'-' | b'+' | b'.' | b'/'))
}
