package org.robotui.message;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/**
 * Files in IDL that come in one text, as servers and logs send them.
 *
 * @param type the full name of the type that is meant
 * @param texts the files by the full names of their types
 */
record IdlFiles(String type, Map<String, String> texts) {

  private static final String HEADING = "IDL: ";

  /** Takes a text apart; what stands before the first heading is the type's own. */
  static IdlFiles of(String type, String fullText) {
    Map<String, StringBuilder> parts = new LinkedHashMap<>();
    StringBuilder current = new StringBuilder();
    parts.put(type, current);
    boolean heading = false;
    for (String line : fullText.split("\n", -1)) {
      if (heading && line.strip().startsWith(HEADING)) {
        String name = Generation.plainName(line.strip().substring(HEADING.length()).strip());
        current = parts.computeIfAbsent(name, each -> new StringBuilder());
      } else if (!MessageSchema.isSeparator(line)) {
        current.append(line).append('\n');
      }
      heading = MessageSchema.isSeparator(line);
    }
    Map<String, String> texts = new LinkedHashMap<>();
    parts.forEach((name, text) -> texts.put(name, text.toString()));
    return new IdlFiles(type, texts);
  }

  MessageSchema schema() throws DefinitionException {
    MessageDefinition root =
        find(type).orElseThrow(() -> new DefinitionException(type, "its file in IDL is not among those that came"));
    return MessageSchema.resolve(root, this::find);
  }

  private Optional<MessageDefinition> find(String name) throws DefinitionException {
    String text = texts.getOrDefault(name, "");
    return text.isBlank() ? Optional.empty()
        : Optional.of(DefinitionParser.parse(name, IdlText.definition(name, "msg", text), Generation.ROS2));
  }
}
