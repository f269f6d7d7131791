package org.robotui.rosbridge.internal;

import java.util.List;
import java.util.Map;
import org.robotui.web.tree.TreeException;
import org.robotui.web.tree.Trees;

/** Writes the definitions that rosapi gives in parts as the text that ROS has for them. */
public final class TypeText {

  private static final String SEPARATOR = "=".repeat(80);

  private TypeText() {}

  /**
   * The text of a type and of those that it refers to.
   *
   * @param types the type itself first
   * @return its definition, then the others, each after a line of equals signs and its name
   * @throws TreeException if something is missing
   */
  public static String of(List<Map<String, Object>> types) throws TreeException {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < types.size(); i++) {
      if (i > 0) {
        text.append(SEPARATOR).append("\nMSG: ").append(line(Trees.text(types.get(i), "type"))).append('\n');
      }
      fields(types.get(i), text);
    }
    return text.toString();
  }

  private static void fields(Map<String, Object> type, StringBuilder text) throws TreeException {
    List<String> names = Trees.texts(type, "fieldnames");
    List<String> types = Trees.texts(type, "fieldtypes");
    List<?> lengths = Trees.list(type, "fieldarraylen");
    if (names.size() != types.size() || names.size() != lengths.size()) {
      throw new TreeException("a type has " + names.size() + " names, " + types.size() + " types and "
          + lengths.size() + " lengths of fields");
    }
    for (int i = 0; i < names.size(); i++) {
      text.append(line(types.get(i))).append(array(lengths.get(i))).append(' ').append(line(names.get(i))).append('\n');
    }
  }

  /** -1 is for what is no array, 0 for one of any length. */
  private static String array(Object length) {
    long most = length instanceof Number number ? number.longValue() : -1;
    return most < 0 ? "" : most == 0 ? "[]" : "[" + most + "]";
  }

  /** Nothing of it may begin a line of its own. */
  private static String line(String text) {
    return text.replaceAll("\\s", " ");
  }
}
