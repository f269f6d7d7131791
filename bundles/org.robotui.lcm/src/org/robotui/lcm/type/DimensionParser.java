package org.robotui.lcm.type;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;

/** Reads the sizes of arrays. */
final class DimensionParser {

  private static final int MOST = 16;

  private final TokenStream tokens;
  private final List<MemberDefinition> before;
  private final List<ConstantDefinition> constants;

  DimensionParser(TokenStream tokens, List<MemberDefinition> before, List<ConstantDefinition> constants) {
    this.tokens = tokens;
    this.before = before;
    this.constants = constants;
  }

  List<Dimension> parse() throws TypeException {
    List<Dimension> dimensions = new ArrayList<>();
    while (tokens.peek().is("[")) {
      Token bracket = tokens.next();
      if (dimensions.size() == MOST) {
        throw new TypeException(bracket.place(), "an array has at most " + MOST + " dimensions",
            "use a struct for the inner ones");
      }
      dimensions.add(dimension(tokens.next()));
      tokens.require("]");
    }
    return dimensions;
  }

  private Dimension dimension(Token size) throws TypeException {
    if (size.is("]") || size.isEnd()) {
      throw new TypeException(size.place(), "an array needs a size",
          "write a number, or the name of an integer member before it");
    }
    if (Character.isDigit(size.text().codePointAt(0))) {
      return fixed(size.text(), size);
    }
    Optional<ConstantDefinition> constant =
        constants.stream().filter(each -> each.name().equals(size.text())).findFirst();
    return constant.isPresent() ? fixed(constant.get().text(), size) : variable(size);
  }

  private static Dimension fixed(String text, Token token) throws TypeException {
    OptionalLong size = Numerals.whole(text);
    if (size.isEmpty() || size.getAsLong() < 1 || size.getAsLong() > Integer.MAX_VALUE) {
      throw new TypeException(token.place(), "an array cannot have the size " + text,
          "write an integer from 1 to " + Integer.MAX_VALUE);
    }
    return new Dimension.Fixed((int) size.getAsLong(), text);
  }

  private Dimension variable(Token size) throws TypeException {
    MemberDefinition member = before.stream().filter(each -> each.name().equals(size.text())).findFirst()
        .orElseThrow(() -> new TypeException(size.place(),
            "the array size " + size.quoted() + " is not declared before the array",
            "declare it above: int32_t " + size.text() + ";"));
    if (member.isArray() || Primitive.of(member.type()).filter(Primitive::isInteger).isEmpty()) {
      throw new TypeException(size.place(), "the array size '" + size.text() + "' is no integer, but a " + member,
          "make it one of int8_t, int16_t, int32_t, int64_t");
    }
    return new Dimension.Variable(size.text());
  }
}
