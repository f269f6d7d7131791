package org.robotui.lcm.type;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Reads what stands between the braces of an enum. */
final class EnumParser {

  private final TokenStream tokens;
  private final Set<String> names = new HashSet<>();
  private final Set<Number> taken = new HashSet<>();
  private final List<ConstantDefinition> values = new ArrayList<>();
  private long greatest;

  EnumParser(TokenStream tokens) {
    this.tokens = tokens;
  }

  List<ConstantDefinition> parse() throws TypeException {
    tokens.require("{");
    while (!tokens.take("}")) {
      value();
      if (!tokens.take(",")) {
        tokens.take(";");
      }
    }
    tokens.take(";");
    return values;
  }

  private void value() throws TypeException {
    Token name = tokens.name();
    Token number = tokens.take("=") ? tokens.next() : new Token(Long.toString(greatest + 1), name.place());
    ConstantDefinition value = ConstantParser.parse(name.text(), Primitive.INT32, number);
    if (!names.add(value.name()) || !taken.add(value.value())) {
      throw new TypeException(name.place(),
          "the name '" + value.name() + "' or the value " + value.value() + " is used twice in this enum",
          "choose another");
    }
    greatest = Math.max(greatest, value.value().longValue());
    values.add(value);
  }
}
