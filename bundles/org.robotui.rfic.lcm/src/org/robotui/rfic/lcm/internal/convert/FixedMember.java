package org.robotui.rfic.lcm.internal.convert;

import org.robotui.lcm.type.LcmType;
import org.robotui.lcm.type.Primitive;
import org.robotui.lcm.type.TypeLibrary;
import org.robotui.rfic.lcm.internal.language.MemberPath;
import org.robotui.rfic.lcm.internal.language.Target;

/** Members of commands that are always the same, as configurations set them. */
final class FixedMember {
  private FixedMember() {}

  static void put(FieldTree tree, String written, String text, LcmType type, TypeLibrary types) {
    MemberPath path = MemberPath.parse(written);
    Target target = Target.of(path, type, types);
    Primitive primitive = target.primitive().orElseThrow(() -> new IllegalArgumentException(
        written + " is a " + target.member().type() + "; set its members one by one"));
    if (target.many()) {
      throw new IllegalArgumentException(
          written + " is declared as '" + target.member() + "'; set its elements one by one, as " + written + "[0]");
    }
    tree.put(path, value(written, text, primitive));
  }

  private static Object value(String written, String text, Primitive primitive) {
    try {
      return switch (primitive) {
        case STRING -> text;
        case FLOAT, DOUBLE -> Double.valueOf(text);
        case BOOLEAN -> flag(text);
        default -> Long.decode(text);
      };
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException(
          "'" + text + "' is nothing that " + written + ", a " + primitive.lcmName() + ", can hold", e);
    }
  }

  private static Boolean flag(String text) {
    return switch (text) {
      case "true", "yes", "on", "1" -> true;
      case "false", "no", "off", "0" -> false;
      default -> throw new NumberFormatException(text);
    };
  }
}
