package org.robotui.web.tree;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.LongStream;
import org.robotui.net.log.PeerText;

/** Reads members of objects whose form is known; errors name the member. */
public final class Trees {

  private Trees() {}

  /**
   * An object.
   *
   * @param tree what was read
   * @return its members
   * @throws TreeException if it is none
   */
  @SuppressWarnings("unchecked") // names are texts in all that is read
  public static Map<String, Object> object(Object tree) throws TreeException {
    if (tree instanceof Map<?, ?> members) {
      return (Map<String, Object>) members;
    }
    throw new TreeException("an object is expected, not " + brief(tree));
  }

  /**
   * A text.
   *
   * @param members of an object
   * @param name the member
   * @return the text
   * @throws TreeException if there is none
   */
  public static String text(Map<String, Object> members, String name) throws TreeException {
    return optionalText(members, name).orElseThrow(() -> wrong(members, name, "a text"));
  }

  /**
   * A text that may be missing.
   *
   * @param members of an object
   * @param name the member
   * @return the text, none also where it is no text
   */
  public static Optional<String> optionalText(Map<String, Object> members, String name) {
    return members.get(name) instanceof String text ? Optional.of(text) : Optional.empty();
  }

  /**
   * An integer.
   *
   * @param members of an object
   * @param name the member
   * @return the number
   * @throws TreeException if there is none
   */
  public static long whole(Map<String, Object> members, String name) throws TreeException {
    return switch (members.get(name)) {
      case Long number -> number;
      case Double number when number == Math.rint(number) && Math.abs(number) < 1e15 -> number.longValue();
      case null, default -> throw wrong(members, name, "an integer");
    };
  }

  /**
   * A list that may be missing.
   *
   * @param members of an object
   * @param name the member
   * @return its items, empty where it is missing
   * @throws TreeException if it is no list
   */
  public static List<?> list(Map<String, Object> members, String name) throws TreeException {
    return switch (members.get(name)) {
      case null -> List.of();
      case JsonNull none -> List.of();
      case List<?> items -> items;
      case long[] numbers -> LongStream.of(numbers).boxed().toList();
      default -> throw wrong(members, name, "a list");
    };
  }

  /**
   * Texts in a list that may be missing.
   *
   * @param members of an object
   * @param name the member
   * @return the texts; what is none is left out
   * @throws TreeException if it is no list
   */
  public static List<String> texts(Map<String, Object> members, String name) throws TreeException {
    return list(members, name).stream().filter(String.class::isInstance).map(String.class::cast).toList();
  }

  private static TreeException wrong(Map<String, Object> members, String name, String expected) {
    return new TreeException("'" + name + "' has to be " + expected + ", and is " + brief(members.get(name)));
  }

  private static String brief(Object value) {
    return switch (value) {
      case null -> "missing";
      case String text -> "'" + PeerText.name(text) + "'";
      case Map<?, ?> members -> "an object";
      case List<?> items -> "a list";
      case Object array when array.getClass().isArray() -> "an array";
      default -> PeerText.name(value.toString());
    };
  }
}
