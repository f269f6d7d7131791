package org.robotui.lcm.type;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;

/**
 * Reads {@code .lcm} files: packages, structs, constants, arrays, comments, and the enums of old files, with the
 * meaning that {@code lcm-gen} gives them.
 *
 * <p>Source: "LCM Type Specification Language" in LCM's documentation.
 */
public final class TypeParser {

  private static final int MAX_TEXT = 1 << 20;
  private static final Pattern FULL_NAME = Pattern.compile("[A-Za-z_]\\w*(\\.[A-Za-z_]\\w*)*");

  private final TokenStream tokens;
  private final List<TypeDefinition> found = new ArrayList<>();
  private String packageName = "";

  private TypeParser(TokenStream tokens) {
    this.tokens = tokens;
  }

  /**
   * Reads a file.
   *
   * @param file how errors name it
   * @param text its text
   * @return its types in order; types they refer to may be elsewhere
   * @throws TypeException if the text is no type specification
   */
  public static List<TypeDefinition> parse(String file, String text) throws TypeException {
    if (text.length() > MAX_TEXT) {
      throw new TypeException(new Place(file, 1, 1), "a file of " + text.length() + " characters is too long",
          "spread its types over files of at most " + MAX_TEXT + " characters");
    }
    TypeParser parser = new TypeParser(new TokenStream(new Tokenizer(file, text)));
    while (!parser.tokens.peek().isEnd()) {
      parser.entity();
    }
    return List.copyOf(parser.found);
  }

  private void entity() throws TypeException {
    Token word = tokens.next();
    switch (word.text()) {
      case "package" -> {
        packageName = fullName("a package", "package mycompany;").text();
        tokens.require(";");
      }
      case "struct" -> struct();
      case "enum" -> enumeration();
      default -> throw new TypeException(word.place(),
          "expected 'package', 'struct' or 'enum' and found " + word.quoted(),
          "declare a type: struct name_t { int64_t utime; }");
    }
  }

  private void struct() throws TypeException {
    Token name = fullName("a struct", "struct pose_t { double x, y; }");
    StructParser body = new StructParser(tokens, this::qualified);
    body.parse();
    found.add(new TypeDefinition.Struct(qualified(name.text()), body.members(), body.constants(), name.place()));
  }

  private void enumeration() throws TypeException {
    Token name = fullName("an enum", "enum mode_t { IDLE = 0, DRIVING = 1 }");
    found.add(new TypeDefinition.Enumeration(qualified(name.text()), new EnumParser(tokens).parse(), name.place()));
  }

  private Token fullName(String bearer, String example) throws TypeException {
    Token name = tokens.next();
    if (!FULL_NAME.matcher(name.text()).matches()) {
      throw new TypeException(name.place(), "expected the name of " + bearer + " and found " + name.quoted(),
          "write for example: " + example);
    }
    return name;
  }

  /** A name without a package is of the package of the file. */
  private String qualified(String name) {
    return name.indexOf('.') >= 0 || packageName.isEmpty() ? name : packageName + "." + name;
  }
}
