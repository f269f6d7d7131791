package org.robotui.message;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.regex.Pattern;

/** The definitions of common types that are part of this library. */
final class ShippedDefinitions implements DefinitionSource {

  private static final Pattern TYPE = Pattern.compile("[A-Za-z]\\w*/[A-Za-z]\\w*");

  @Override
  public Optional<MessageDefinition> find(String type) throws DefinitionException {
    Optional<String> text = text(type, ".msg");
    return text.isPresent()
        ? Optional.of(DefinitionParser.parse(type, text.get()))
        : ServiceDefinition.messageOf(type, this::service);
  }

  Optional<ServiceDefinition> service(String type) throws DefinitionException {
    Optional<String> text = text(type, ".srv");
    return text.isEmpty() ? Optional.empty() : Optional.of(ServiceDefinition.parse(type, text.get()));
  }

  /** The complete type of a compiled codec, which is always shipped. */
  static MessageSchema schema(String type) {
    ShippedDefinitions shipped = new ShippedDefinitions();
    try {
      MessageDefinition definition = shipped.find(type)
          .orElseThrow(() -> new IllegalArgumentException("no definition of " + type + " is shipped"));
      return MessageSchema.resolve(definition, shipped);
    } catch (DefinitionException e) {
      throw new IllegalArgumentException("the shipped definition of " + type + " is broken", e);
    }
  }

  private static Optional<String> text(String type, String suffix) {
    if (!TYPE.matcher(type).matches()) {
      return Optional.empty();
    }
    try (InputStream in = ShippedDefinitions.class.getResourceAsStream("definitions/" + type + suffix)) {
      return in == null
          ? Optional.empty()
          : Optional.of(new String(in.readAllBytes(), StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new UncheckedIOException("the shipped definition of " + type + " cannot be read", e);
    }
  }
}
