package org.robotui.uic.topics.internal.model;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.robotui.api.port.Browser.Kind;
import org.robotui.ui.ask.Measure;
import org.robotui.uic.topics.internal.model.TopicRow.Counts;

/** Makes the rows of the list. Pure, but for counting its work. */
final class RowMaker {
  private final Function<Key, Optional<Poller.Known>> known;
  private long looked;

  RowMaker(Function<Key, Optional<Poller.Known>> known) {
    this.known = known;
  }

  List<TopicRow> rows(Catalog catalog, Wishes wishes, Map<Key, Measure> measures) {
    String[] words = words(wishes.filter());
    boolean several = catalog.robots().size() > 1;
    List<TopicRow> rows = new ArrayList<>();
    for (Entry entry : catalog.of(wishes.section())) {
      looked++;
      if (matches(entry, words)) {
        rows.add(row(entry, several, wishes, measures));
      }
    }
    return rows;
  }

  /** Whether the list shows a thing of a kind under a filter. */
  static boolean lists(Kind section, String filter, Entry entry) {
    return entry.key().kind() == section && matches(entry, words(filter));
  }

  /** How many of each kind the filter leaves. */
  Map<Kind, Integer> counts(Catalog catalog, String filter) {
    String[] words = words(filter);
    Map<Kind, Integer> counts = new EnumMap<>(Kind.class);
    for (Kind kind : Catalog.KINDS) {
      List<Entry> all = catalog.of(kind);
      looked += words.length == 0 ? 0 : all.size();
      counts.put(kind, words.length == 0 ? all.size() : (int) all.stream().filter(e -> matches(e, words)).count());
    }
    return Map.copyOf(counts);
  }

  /** How many things were looked at so far, for tests of what it costs. */
  long looked() {
    return looked;
  }

  private TopicRow row(Entry entry, boolean several, Wishes wishes, Map<Key, Measure> measures) {
    Key key = entry.key();
    Optional<Poller.Known> more = known.apply(key);
    String type = entry.type().isEmpty() ? more.map(Poller.Known::type).orElse("") : entry.type();
    return new TopicRow(entry, several ? key.robot() + "  " + key.name() : key.name(), type,
        more.map(Poller.Known::counts).orElse(Counts.UNKNOWN), wishes.measured().contains(key),
        Optional.ofNullable(measures.get(key)));
  }

  private static String[] words(String filter) {
    return filter.isBlank() ? new String[0] : filter.strip().toLowerCase(Locale.ROOT).split("\\s+");
  }

  private static boolean matches(Entry entry, String... words) {
    for (String word : words) {
      if (!contains(entry.key().name(), word) && !contains(entry.type(), word)
          && !contains(entry.key().robot(), word)) {
        return false;
      }
    }
    return true;
  }

  private static boolean contains(String text, String word) {
    return text.toLowerCase(Locale.ROOT).contains(word);
  }
}
