package org.robotui.ros.internal.xmlrpc;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.CodingErrorAction;
import java.nio.charset.StandardCharsets;

/**
 * Reads the subset of XML that XML-RPC needs: elements without attributes, text, comments, CDATA and the five
 * predefined entities. Document types are refused, so that no entity can be declared, let alone expanded.
 */
final class XmlScanner {

  private static final int MAX_ENTITY = 10;

  private final String text;
  private int at;

  XmlScanner(byte[] utf8) throws XmlRpcException {
    text = decode(utf8);
    at = text.startsWith("\uFEFF") ? 1 : 0;
  }

  private static String decode(byte[] utf8) throws XmlRpcException {
    try {
      return StandardCharsets.UTF_8.newDecoder()
          .onMalformedInput(CodingErrorAction.REPORT)
          .onUnmappableCharacter(CodingErrorAction.REPORT)
          .decode(ByteBuffer.wrap(utf8)).toString();
    } catch (CharacterCodingException e) {
      throw new XmlRpcException("the document is not UTF-8: " + e.getMessage());
    }
  }

  /** Whether {@code <name>} or {@code <name/>} comes next, after white space and comments. */
  boolean opens(String name) throws XmlRpcException {
    skipMisc();
    return tagAt(name, 1) && text.charAt(at) == '<';
  }

  /** Reads {@code <name>}; answers false for {@code <name/>}, which has no content and no end tag. */
  boolean open(String name) throws XmlRpcException {
    if (!opens(name)) {
      throw error("expected <" + name + ">");
    }
    at += 1 + name.length();
    skipSpace();
    boolean empty = take("/");
    if (!take(">")) {
      throw error("expected '>' after <" + name);
    }
    return !empty;
  }

  /** Reads {@code </name>}. */
  void close(String name) throws XmlRpcException {
    skipMisc();
    if (!text.startsWith("</", at) || !tagAt(name, 2)) {
      throw error("expected </" + name + ">");
    }
    at += 2 + name.length();
    skipSpace();
    if (!take(">")) {
      throw error("expected '>' after </" + name);
    }
  }

  /** The name of the element that opens here, without reading it; empty if none does. */
  String peekElement() throws XmlRpcException {
    skipMisc();
    int end = at + 1;
    while (end < text.length() && isNameChar(text.charAt(end))) {
      end++;
    }
    return at < text.length() && text.charAt(at) == '<' ? text.substring(at + 1, end) : "";
  }

  /** Character data up to the next tag. */
  String text() throws XmlRpcException {
    StringBuilder out = new StringBuilder();
    while (at < text.length()) {
      char c = text.charAt(at);
      if (c == '&') {
        entity(out);
      } else if (c != '<') {
        run(out);
      } else if (!takeComment() && !takeCdata(out)) {
        break;
      }
    }
    return out.toString();
  }

  /** Demands that nothing but white space and comments is left. */
  void end() throws XmlRpcException {
    skipMisc();
    if (at < text.length()) {
      throw error("unexpected content after the document");
    }
  }

  /** Skips the XML declaration and what else may stand before the document. */
  void prolog() throws XmlRpcException {
    skipMisc();
    if (text.startsWith("<!DOCTYPE", at)) {
      throw error("document types are not accepted");
    }
  }

  XmlRpcException error(String problem) {
    return new XmlRpcException(problem + " at character " + at);
  }

  private void run(StringBuilder out) {
    int start = at;
    while (at < text.length() && text.charAt(at) != '<' && text.charAt(at) != '&') {
      at++;
    }
    out.append(text, start, at);
  }

  private void entity(StringBuilder out) throws XmlRpcException {
    int end = text.indexOf(';', at);
    if (end < 0 || end - at > MAX_ENTITY) {
      throw error("'&' that starts no character reference");
    }
    out.appendCodePoint(codePoint(text.substring(at + 1, end)));
    at = end + 1;
  }

  private int codePoint(String name) throws XmlRpcException {
    return switch (name) {
      case "lt" -> '<';
      case "gt" -> '>';
      case "amp" -> '&';
      case "apos" -> '\'';
      case "quot" -> '"';
      default -> numeric(name);
    };
  }

  private int numeric(String name) throws XmlRpcException {
    try {
      int code = name.startsWith("#x") ? Integer.parseUnsignedInt(name.substring(2), 16)
          : name.startsWith("#") ? Integer.parseUnsignedInt(name.substring(1)) : -1;
      if (Character.isValidCodePoint(code)) {
        return code;
      }
    } catch (NumberFormatException e) {
      // falls through to the one error for all that is not a character
    }
    throw error("unknown entity &" + name + ";");
  }

  private boolean takeComment() throws XmlRpcException {
    return takeBetween("<!--", "-->");
  }

  private boolean takeCdata(StringBuilder out) throws XmlRpcException {
    int start = at + "<![CDATA[".length();
    if (!takeBetween("<![CDATA[", "]]>")) {
      return false;
    }
    out.append(text, start, at - "]]>".length());
    return true;
  }

  private boolean takeBetween(String start, String end) throws XmlRpcException {
    if (!text.startsWith(start, at)) {
      return false;
    }
    int stop = text.indexOf(end, at + start.length());
    if (stop < 0) {
      throw error(start + " without " + end);
    }
    at = stop + end.length();
    return true;
  }

  private void skipMisc() throws XmlRpcException {
    do {
      skipSpace();
    } while (takeComment() || takeBetween("<?", "?>"));
  }

  private void skipSpace() {
    while (at < text.length() && " \t\r\n".indexOf(text.charAt(at)) >= 0) {
      at++;
    }
  }

  private boolean take(String token) {
    boolean there = text.startsWith(token, at);
    at += there ? token.length() : 0;
    return there;
  }

  private boolean tagAt(String name, int skip) {
    int end = at + skip + name.length();
    return at < text.length() && text.startsWith(name, at + skip)
        && (end >= text.length() || !isNameChar(text.charAt(end)));
  }

  private static boolean isNameChar(char c) {
    return c >= 'a' && c <= 'z' || c >= 'A' && c <= 'Z' || c >= '0' && c <= '9' || c == '.' || c == '_' || c == '-'
        || c == ':';
  }
}
