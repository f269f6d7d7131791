package org.robotui.message;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;

/** The definitions of common types that are part of this library. */
final class ShippedDefinitions implements Definitions {

  private final Generation generation;

  ShippedDefinitions() {
    this(Generation.ROS1);
  }

  ShippedDefinitions(Generation generation) {
    this.generation = generation;
  }

  @Override
  public Optional<MessageDefinition> find(String type) throws DefinitionException {
    Optional<String> text = text(type, ".msg");
    return text.isPresent()
        ? Optional.of(DefinitionParser.parse(type, text.get(), generation))
        : ServiceDefinition.messageOf(type, this::service);
  }

  @Override
  public Optional<ServiceDefinition> service(String type) throws DefinitionException {
    Optional<String> text = text(type, ".srv");
    return text.isEmpty() ? Optional.empty() : Optional.of(ServiceDefinition.parse(type, text.get(), generation));
  }

  @Override
  public Optional<ActionDefinition> action(String type) throws DefinitionException {
    Optional<String> text = text(type, ".action");
    return text.isEmpty() ? Optional.empty() : Optional.of(ActionDefinition.parse(type, text.get()));
  }

  boolean has(String type) {
    return text(type, ".msg").isPresent() || text(type.replaceFirst("(Request|Response)$", ""), ".srv").isPresent();
  }

  /** The complete type of a compiled codec, which is always shipped. */
  static MessageSchema schema(String type) {
    return schema(type, Generation.ROS1);
  }

  static MessageSchema schema(String type, Generation generation) {
    ShippedDefinitions shipped = new ShippedDefinitions(generation);
    try {
      Optional<MessageDefinition> definition = shipped.find(type);
      if (definition.isEmpty()) {
        throw new IllegalArgumentException("no definition of " + type + " is shipped");
      }
      return MessageSchema.resolve(definition.get(), shipped);
    } catch (DefinitionException e) {
      throw new IllegalArgumentException("the shipped definition of " + type + " is broken", e);
    }
  }

  /** One text is for both generations, unless ROS 2 has changed the type. */
  private Optional<String> text(String type, String suffix) {
    if (!Names.isFullName(type)) {
      return Optional.empty();
    }
    Optional<String> changed = generation == Generation.ROS2 ? resource("ros2/" + type, suffix) : Optional.empty();
    return changed.isPresent() ? changed : resource(type, suffix);
  }

  private static Optional<String> resource(String type, String suffix) {
    try (InputStream in = ShippedDefinitions.class.getResourceAsStream("definitions/" + type + suffix)) {
      return in == null
          ? Optional.empty()
          : Optional.of(new String(in.readAllBytes(), StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new UncheckedIOException("the shipped definition of " + type + " cannot be read", e);
    }
  }
}
