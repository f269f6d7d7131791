package org.robotui.lcm.type;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.regex.Pattern;

/** Reads what stands between the braces of a struct. */
final class StructParser {

  private static final Pattern TYPE = Pattern.compile("[A-Za-z_]\\w*(\\.[A-Za-z_]\\w*)*");
  private static final Set<String> COMMON_MISTAKES = Set.of("int", "short", "long", "char", "unsigned", "bool",
      "uint8_t", "uint16_t", "uint32_t", "uint64_t", "float32", "float64");

  private final TokenStream tokens;
  private final UnaryOperator<String> qualified;
  private final Set<String> names = new HashSet<>();
  private final List<MemberDefinition> members = new ArrayList<>();
  private final List<ConstantDefinition> constants = new ArrayList<>();
  private final DimensionParser dimensions;

  StructParser(TokenStream tokens, UnaryOperator<String> qualified) {
    this.tokens = tokens;
    this.qualified = qualified;
    this.dimensions = new DimensionParser(tokens, members, constants);
  }

  List<MemberDefinition> members() {
    return members;
  }

  List<ConstantDefinition> constants() {
    return constants;
  }

  void parse() throws TypeException {
    tokens.require("{");
    while (!tokens.take("}")) {
      if (tokens.take("const")) {
        declareConstants();
      } else {
        declareMembers();
      }
    }
    tokens.take(";"); // not of the language, and not worth an error
  }

  private void declareMembers() throws TypeException {
    Token type = tokens.next();
    check(type);
    String name = Primitive.of(type.text()).isPresent() ? type.text() : qualified.apply(type.text());
    do {
      Token member = freshName();
      members.add(new MemberDefinition(member.text(), name, dimensions.parse(), member.place()));
    } while (tokens.take(","));
    tokens.require(";");
  }

  private static void check(Token type) throws TypeException {
    if (!TYPE.matcher(type.text()).matches()) {
      throw new TypeException(type.place(), "expected the type of a member and found " + type.quoted(),
          "write for example: double x;");
    }
    if (COMMON_MISTAKES.contains(type.text())) {
      throw new TypeException(type.place(), "LCM has no type '" + type.text() + "'",
          "take one of int8_t, int16_t, int32_t, int64_t, byte, float, double, boolean, string");
    }
    if (type.is("struct") || type.is("enum")) {
      throw new TypeException(type.place(), "a type cannot be declared inside another",
          "declare it before this struct, and use its name");
    }
  }

  private void declareConstants() throws TypeException {
    Token word = tokens.next();
    Primitive type = Primitive.of(word.text()).filter(primitive -> primitive.isInteger() || primitive.isFloating())
        .orElseThrow(() -> new TypeException(word.place(), "a constant cannot be of type " + word.quoted(),
            "take one of int8_t, int16_t, int32_t, int64_t, float, double"));
    do {
      Token name = freshName();
      tokens.require("=");
      constants.add(ConstantParser.parse(name.text(), type, tokens.next()));
    } while (tokens.take(","));
    tokens.require(";");
  }

  private Token freshName() throws TypeException {
    Token name = tokens.name();
    if (!names.add(name.text())) {
      throw new TypeException(name.place(), "the name '" + name.text() + "' is used twice in this struct",
          "choose another");
    }
    return name;
  }
}
