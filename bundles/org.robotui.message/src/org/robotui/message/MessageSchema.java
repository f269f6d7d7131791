package org.robotui.message;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A message type with all the types it refers to: complete, not recursive, with known sizes.
 */
public final class MessageSchema {

  private static final String SEPARATOR = "=".repeat(80);
  private static final String NESTED = "MSG: ";

  private final MessageDefinition definition;
  private final Map<String, MessageDefinition> nested;
  private final Layout layout;
  private final String fullText;
  private volatile MessageInfo info;

  private MessageSchema(MessageDefinition definition, Map<String, MessageDefinition> nested, String fullText)
      throws DefinitionException {
    this.definition = definition;
    this.nested = Map.copyOf(nested);
    this.layout = new LayoutCompiler(nested).compile(definition);
    this.fullText = fullText;
  }

  /**
   * Puts a type together from its definition and a source of the others.
   *
   * @param definition the type
   * @param source where to find the types it refers to
   * @return the complete type, with the full text as ROS's generator writes it
   * @throws DefinitionException if a type is missing, broken, recursive, or nested too deeply
   */
  public static MessageSchema resolve(MessageDefinition definition, DefinitionSource source)
      throws DefinitionException {
    Map<String, MessageDefinition> found = Dependencies.of(definition, source);
    StringBuilder text = new StringBuilder(definition.text());
    for (MessageDefinition each : found.values()) {
      text.append('\n').append(SEPARATOR).append('\n').append(NESTED).append(each.type()).append('\n')
          .append(each.text());
    }
    return new MessageSchema(definition, found, text.toString());
  }

  /**
   * Reads the full text of a connection header: the type's own definition, then those it refers to, each after a line
   * of equals signs and a line {@code MSG: package/Type}.
   *
   * @param type the type's full name
   * @param fullText the text; it is kept as it is
   * @return the complete type
   * @throws DefinitionException if a type is missing, broken, recursive, or nested too deeply
   */
  public static MessageSchema parse(String type, String fullText) throws DefinitionException {
    return parse(type, fullText, Generation.ROS1);
  }

  /**
   * Reads the full text of a type: its own definition, then those it refers to, each after a line of equals signs and a
   * line {@code MSG: package/Type}, as connection headers, logs and type descriptions have it.
   *
   * @param type the type's full name
   * @param fullText the text; it is kept as it is
   * @param generation whose definitions they are
   * @return the complete type
   * @throws DefinitionException if a type is missing, broken, recursive, or nested too deeply
   */
  public static MessageSchema parse(String type, String fullText, Generation generation) throws DefinitionException {
    if (fullText.length() > DefinitionParser.MAX_TEXT) {
      throw new DefinitionException(type, "the text of " + fullText.length() + " characters is too long");
    }
    String plain = Generation.plainName(type);
    Map<String, String> texts = split(plain, fullText);
    MessageDefinition root = DefinitionParser.parse(plain, texts.get(plain), generation);
    Map<String, MessageDefinition> found = Dependencies.of(root, name -> {
      String text = texts.get(name);
      return text == null ? Optional.empty()
          : Optional.of(DefinitionParser.parse(name, text, generation));
    });
    return new MessageSchema(root, found, fullText);
  }

  /**
   * Reads the full text of a type in IDL: the files of the type and of those it refers to, each after a line of equals
   * signs and a line {@code IDL: package/msg/Type}.
   *
   * @param type the type's full name
   * @param fullText the text
   * @return the complete type
   * @throws DefinitionException if a type is missing, broken, recursive, or nested too deeply
   */
  public static MessageSchema parseIdl(String type, String fullText) throws DefinitionException {
    if (fullText.length() > DefinitionParser.MAX_TEXT) {
      throw new DefinitionException(type, "the text of " + fullText.length() + " characters is too long");
    }
    return IdlFiles.of(Generation.plainName(type), fullText).schema();
  }

  private static Map<String, String> split(String type, String fullText) throws DefinitionException {
    Map<String, List<String>> parts = new LinkedHashMap<>();
    List<String> current = new ArrayList<>();
    parts.put(type, current);
    boolean expectName = false;
    for (String line : fullText.split("\n", -1)) {
      if (expectName) {
        current = new ArrayList<>();
        parts.putIfAbsent(nestedName(type, line), current);
        expectName = false;
      } else if (isSeparator(line)) {
        expectName = true;
      } else {
        current.add(line);
      }
    }
    Map<String, String> texts = new LinkedHashMap<>();
    parts.forEach((name, lines) -> texts.put(name, String.join("\n", lines)));
    return texts;
  }

  static boolean isSeparator(String line) {
    String stripped = line.strip();
    return stripped.length() >= 3 && stripped.chars().allMatch(c -> c == '=');
  }

  private static String nestedName(String type, String line) throws DefinitionException {
    String stripped = line.strip();
    if (!stripped.startsWith(NESTED)) {
      throw new DefinitionException(type, "expected '" + NESTED + "package/Type' after a line of equals signs");
    }
    String name = stripped.substring(NESTED.length()).strip();
    return name.equals("roslib/Header") ? "std_msgs/Header" : Generation.plainName(name);
  }

  /**
   * The type's name, MD5 sum and full text.
   *
   * @return the identity announced to peers
   */
  public MessageInfo info() {
    MessageInfo known = info;
    if (known == null) {
      // many types are read whose sum nobody compares
      known = new MessageInfo(definition.type(), new Md5(nested).of(definition), fullText);
      info = known;
    }
    return known;
  }

  /**
   * The type's own definition.
   *
   * @return its fields and constants
   */
  public MessageDefinition definition() {
    return definition;
  }

  /**
   * The definitions of all types this one refers to, directly or not.
   *
   * @return by full name
   */
  public Map<String, MessageDefinition> nested() {
    return nested;
  }

  Optional<MessageDefinition> definitionOf(String type) {
    return definition.type().equals(type) ? Optional.of(definition) : Optional.ofNullable(nested.get(type));
  }

  /**
   * The fewest bytes a message of this type can have.
   *
   * @return bytes
   */
  public long minSize() {
    return layout.minSize();
  }

  Layout layout() {
    return layout;
  }
}
