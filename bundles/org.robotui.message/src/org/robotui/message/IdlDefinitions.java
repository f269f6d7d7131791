package org.robotui.message;

import java.util.Map;
import java.util.Optional;

/**
 * Definitions of other frameworks in IDL, many in a text: one text for each module, which holds the structures of that
 * module. A type is named by its module and its structure, such as {@code CommBasicObjects/CommPose3d}. Immutable.
 */
public final class IdlDefinitions implements DefinitionSource {

  private final Map<String, String> texts;

  /**
   * Keeps texts, which are read when they are asked for.
   *
   * @param texts by the names of their modules
   */
  public IdlDefinitions(Map<String, String> texts) {
    this.texts = Map.copyOf(texts);
  }

  @Override
  public Optional<MessageDefinition> find(String type) throws DefinitionException {
    int slash = type.indexOf('/');
    String text = slash < 0 ? "" : texts.getOrDefault(type.substring(0, slash), "");
    if (text.length() > DefinitionParser.MAX_TEXT) {
      throw new DefinitionException(type, "the text of " + text.length() + " characters is too long");
    }
    return text.isEmpty() ? Optional.empty()
        : Optional.of(DefinitionParser.parse(type, IdlText.definition(type, "msg", text), Generation.ROS2));
  }

  /**
   * A type with all that it refers to.
   *
   * @param type its full name
   * @return the complete type
   * @throws DefinitionException if it is not there, broken, recursive, or nested too deeply
   */
  public MessageSchema schema(String type) throws DefinitionException {
    MessageDefinition found =
        find(type).orElseThrow(() -> new DefinitionException(type, "no description of its module is known"));
    return MessageSchema.resolve(found, this);
  }
}
