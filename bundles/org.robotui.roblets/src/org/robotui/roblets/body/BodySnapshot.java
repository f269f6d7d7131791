package org.robotui.roblets.body;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.TreeMap;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.tree.BodyPath;

/**
 * The state of a whole body at one moment: an element {@code body}, in it one for each roblet, sorted by name, and in
 * each the last of its messages of each name. It is immutable.
 *
 * @param parts the messages, by roblets and by their names
 * @param tree the same as one tree
 */
public record BodySnapshot(Map<String, Map<String, BodyEntry>> parts, BodyElement tree) {
  /** The name of the root. */
  public static final String ROOT = "body";

  /** Nobody has said anything. */
  public static final BodySnapshot EMPTY = new BodySnapshot(Map.of(), BodyElement.of(ROOT));

  /** With a message more, or in the place of one of its name. */
  BodySnapshot with(String roblet, BodyEntry entry) {
    Map<String, BodyEntry> messages = new TreeMap<>(parts.getOrDefault(roblet, Map.of()));
    messages.put(entry.element().name(), entry);
    Map<String, Map<String, BodyEntry>> all = new TreeMap<>(parts);
    all.put(roblet, Collections.unmodifiableMap(messages));
    return of(all);
  }

  BodySnapshot without(String roblet) {
    Map<String, Map<String, BodyEntry>> all = new TreeMap<>(parts);
    all.remove(roblet);
    return of(all);
  }

  private static BodySnapshot of(Map<String, Map<String, BodyEntry>> all) {
    List<BodyElement> roblets = all.entrySet().stream().map(each -> BodyElement.of(each.getKey())
        .with(each.getValue().values().stream().map(BodyEntry::element).toList())).toList();
    return new BodySnapshot(Collections.unmodifiableMap(all), BodyElement.of(ROOT).with(roblets));
  }

  /**
   * What a roblet said last.
   *
   * @param roblet who
   * @param message the name of what it said
   * @return none where it never said such a thing
   */
  public Optional<BodyEntry> entry(String roblet, String message) {
    return Optional.ofNullable(parts.getOrDefault(roblet, Map.of()).get(message));
  }

  /**
   * How old it is what a roblet said last.
   *
   * @param roblet who
   * @param message the name of what it said
   * @param nowNanos {@link System#nanoTime()}
   * @return nanoseconds; none where it never said such a thing
   */
  public OptionalLong age(String roblet, String message, long nowNanos) {
    return entry(roblet, message).stream().mapToLong(entry -> nowNanos - entry.receivedNanos()).findFirst();
  }

  /**
   * The elements to which a path leads.
   *
   * @param path begins with roblets
   * @return in the order of the tree
   */
  public List<BodyElement> elements(BodyPath path) {
    return path.elements(tree);
  }

  /**
   * The texts to which a path leads.
   *
   * @param path begins with roblets
   * @return in the order of the tree
   */
  public List<String> values(BodyPath path) {
    return path.values(tree);
  }

  /**
   * The first number to which a path leads.
   *
   * @param path begins with roblets
   * @return none where there is no number
   */
  public OptionalDouble number(BodyPath path) {
    return path.number(tree);
  }
}
