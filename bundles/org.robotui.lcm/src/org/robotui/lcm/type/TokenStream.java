package org.robotui.lcm.type;

import java.util.regex.Pattern;

/** Tokens with one to look ahead at. */
final class TokenStream {

  private static final Pattern NAME = Pattern.compile("[A-Za-z_]\\w*");

  private final Tokenizer tokenizer;
  private Token ahead;

  TokenStream(Tokenizer tokenizer) throws TypeException {
    this.tokenizer = tokenizer;
    this.ahead = tokenizer.next();
  }

  Token peek() {
    return ahead;
  }

  Token next() throws TypeException {
    Token token = ahead;
    ahead = token.isEnd() ? token : tokenizer.next();
    return token;
  }

  /** Takes the next token if it is this one. */
  boolean take(String text) throws TypeException {
    if (!ahead.is(text)) {
      return false;
    }
    next();
    return true;
  }

  void require(String text) throws TypeException {
    Token token = next();
    if (!token.is(text)) {
      throw new TypeException(token.place(), "expected '" + text + "' and found " + token.quoted(),
          "write '" + text + "' before it");
    }
  }

  Token name() throws TypeException {
    Token token = next();
    if (!NAME.matcher(token.text()).matches()) {
      throw new TypeException(token.place(), "expected a name and found " + token.quoted(),
          "a name has letters, digits and underscores, and begins with no digit");
    }
    return token;
  }
}
