package org.robotui.lcm.tests;

import java.util.List;
import java.util.Random;

/** A file of types as nobody would write them: structs in structs, arrays of everything, some that hold each other. */
final class RandomTypes {

  static final int COUNT = 12;

  private static final List<String> BUILTIN =
      List.of("int8_t", "int16_t", "int32_t", "int64_t", "byte", "float", "double", "boolean", "string");

  private final Random random;
  private final StringBuilder text = new StringBuilder("package wild;\n");

  private RandomTypes(Random random) {
    this.random = random;
  }

  static String file(long seed) {
    RandomTypes types = new RandomTypes(new Random(seed));
    for (int type = 0; type < COUNT; type++) {
      types.struct(type);
    }
    return types.text.toString();
  }

  private void struct(int type) {
    text.append("struct type_").append(type).append(" { int").append(8 << random.nextInt(4))
        .append("_t n; int16_t size_2;");
    for (int member = random.nextInt(6); member >= 0; member--) {
      String name = " member_" + member + (random.nextBoolean() ? "_x" : "");
      if (random.nextInt(3) > 0) {
        text.append(' ').append(BUILTIN.get(random.nextInt(BUILTIN.size()))).append(name)
            .append(dimensions(random.nextInt(4)));
      } else if (type > 0 && random.nextInt(4) > 0) {
        text.append(" type_").append(random.nextInt(type)).append(name).append(dimensions(random.nextInt(3)));
      } else {
        text.append(" type_").append(random.nextInt(Math.min(COUNT, type + 2))).append(name).append("[n]");
      }
      text.append(';');
    }
    text.append(" }\n");
  }

  private String dimensions(int count) {
    StringBuilder dimensions = new StringBuilder();
    for (int i = 0; i < count; i++) {
      dimensions.append(List.of("[n]", "[size_2]", "[3]", "[0x2]").get(random.nextInt(4)));
    }
    return dimensions.toString();
  }
}
