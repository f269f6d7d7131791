package org.robotui.message.topic;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.api.port.Browser.Description;
import org.robotui.api.port.Browser.Item;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;
import org.robotui.message.data.MessageShapes;

/** What is told of a thing that a robot has, as it is gathered. For one thread. */
public final class ItemFacts {
  private static final String PARTS = "\n---\n";

  private final Map<String, String> facts = new LinkedHashMap<>();

  /** Nothing is known yet. */
  public ItemFacts() {
    // Facts come one by one.
  }

  /**
   * Adds a fact.
   *
   * @param name what it is
   * @param text what it says
   * @return this
   */
  public ItemFacts with(String name, String text) {
    facts.put(name, text);
    return this;
  }

  /**
   * Adds names.
   *
   * @param name what they are
   * @param names any number of them
   * @return this
   */
  public ItemFacts with(String name, List<String> names) {
    return with(name, names.isEmpty() ? "none" : String.join(", ", names));
  }

  /**
   * A type, or the fact why it is not known.
   *
   * @param lookup the answer to the question for it
   * @param <S> its kind
   * @return the type, or none
   */
  public <S> Optional<S> found(SchemaLookup<S> lookup) {
    return switch (lookup) {
      case SchemaLookup.Found<S> found -> Optional.of(found.schema());
      case SchemaLookup.Missing<S> missing -> {
        with("definition", missing.reason());
        yield Optional.empty();
      }
    };
  }

  /**
   * A thing without a type.
   *
   * @param item the thing
   * @return all that is known of it
   */
  public Description plain(Item item) {
    return new Description(item, facts, Optional.empty(), Optional.empty(), Optional.empty());
  }

  /**
   * A thing with messages of one type.
   *
   * @param item the thing
   * @param schema the type, if it is known
   * @return all that is known of it
   */
  public Description ofMessage(Item item, Optional<MessageSchema> schema) {
    return new Description(item, facts, schema.map(ItemFacts::text), schema.map(MessageShapes::of), Optional.empty());
  }

  /**
   * A thing that is asked and answers.
   *
   * @param item the thing
   * @param parts the types of what goes in, of what comes back, and of what is said meanwhile; none where they are not
   * known
   * @return all that is known of it
   */
  public Description ofCall(Item item, List<MessageSchema> parts) {
    if (parts.isEmpty()) {
      return plain(item);
    }
    String definition = parts.stream().map(ItemFacts::text).collect(Collectors.joining(PARTS));
    Stream<MessageSchema> reply = parts.stream().skip(1).limit(1);
    return new Description(item, facts, Optional.of(definition), Optional.of(MessageShapes.of(parts.getFirst())),
        reply.findFirst().map(MessageShapes::of));
  }

  private static String text(MessageSchema schema) {
    return schema.info().definition();
  }
}
