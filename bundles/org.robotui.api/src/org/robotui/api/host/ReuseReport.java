package org.robotui.api.host;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Which bundles are used by which RUICs: what they share, and by what they differ.
 *
 * @param ruics names of the RUICs
 * @param rows by kind, then by bundle
 */
public record ReuseReport(List<String> ruics, List<Row> rows) {
  /** Nothing is used. */
  public static final ReuseReport EMPTY = new ReuseReport(List.of(), List.of());

  /** What a bundle brings. */
  public enum Kind {
    /** A type of RUIC. */
    RUIC,
    /** A type of robot interface. */
    RFIC,
    /** A type of view. */
    UIC,
    /** An entity. */
    ENTITY,
    /** What these are built on: libraries of frameworks, drawing, data. */
    BASE
  }

  /**
   * A bundle.
   *
   * @param kind what it brings
   * @param bundle its symbolic name
   * @param name what users call what it brings
   * @param users names of the RUICs that use it, in their order
   */
  public record Row(Kind kind, String bundle, String name, List<String> users) {
    /**
     * Copies the list.
     *
     * @param kind what it brings
     * @param bundle its symbolic name
     * @param name what users call what it brings
     * @param users the RUICs that use it
     */
    public Row {
      users = List.copyOf(users);
    }
  }

  /**
   * Two RUICs beside each other.
   *
   * @param one a RUIC
   * @param other another one
   * @param shared how many bundles both use
   * @param onlyOne how many only the one uses
   * @param onlyOther how many only the other uses
   */
  public record Pair(String one, String other, long shared, long onlyOne, long onlyOther) {}

  /**
   * Copies the lists.
   *
   * @param ruics names of the RUICs
   * @param rows by kind, then by bundle
   */
  public ReuseReport {
    ruics = List.copyOf(ruics);
    rows = List.copyOf(rows);
  }

  /**
   * All pairs of RUICs.
   *
   * @return in the order of the RUICs
   */
  public List<Pair> pairs() {
    List<Pair> pairs = new ArrayList<>();
    for (int i = 0; i < ruics.size(); i++) {
      for (int j = i + 1; j < ruics.size(); j++) {
        pairs.add(pair(ruics.get(i), ruics.get(j)));
      }
    }
    return pairs;
  }

  private Pair pair(String one, String other) {
    return new Pair(one, other, count(one, other, true, true), count(one, other, true, false),
        count(one, other, false, true));
  }

  private long count(String one, String other, boolean withOne, boolean withOther) {
    return rows.stream().filter(r -> r.users().contains(one) == withOne && r.users().contains(other) == withOther)
        .count();
  }

  /**
   * How many bundles all RUICs use.
   *
   * @return a count, 0 without RUICs
   */
  public long sharedByAll() {
    return rows.stream().filter(r -> r.users().size() == ruics.size()).count();
  }

  /**
   * A sentence.
   *
   * @return for example {@code Natalie and Keira share 31 of 37 bundles}
   */
  public String summary() {
    if (ruics.isEmpty()) {
      return "no robot UI runs";
    }
    String names = ruics.size() == 1 ? ruics.getFirst() + " uses "
        : String.join(", ", ruics.subList(0, ruics.size() - 1)) + " and " + ruics.getLast() + " share " + sharedByAll()
            + " of ";
    return names + rows.size() + " bundles";
  }

  /**
   * The matrix as a Markdown table, with the pairs below it.
   *
   * @return lines
   */
  public String markdown() {
    List<String> lines = new ArrayList<>();
    lines.add("| kind | bundle | " + ruics.stream().map(ReuseReport::escaped).collect(Collectors.joining(" | "))
        + " | used by |");
    lines.add("|---|---|" + ":-:|".repeat(ruics.size()) + "--:|");
    for (Row row : rows) {
      String cells = ruics.stream().map(r -> row.users().contains(r) ? "x" : " ").collect(Collectors.joining(" | "));
      lines.add("| " + word(row.kind()) + " | `" + row.bundle() + "` | " + cells + " | " + row.users().size() + " |");
    }
    if (ruics.size() > 1) {
      lines.add("");
      lines.add("| | | shared | only the first | only the second |");
      lines.add("|---|---|--:|--:|--:|");
      pairs().forEach(p -> lines
          .add("| " + escaped(p.one()) + " | " + escaped(p.other()) + " | " + p.shared() + " | " + p.onlyOne() + " | "
              + p.onlyOther() + " |"));
    }
    return String.join("\n", lines) + "\n";
  }

  private static String escaped(String name) {
    return name.replace("|", "\\|");
  }

  /**
   * The matrix as comma-separated values with a heading: kind, bundle, name, a column per RUIC with 1 or 0, count of
   * users.
   *
   * @return lines
   */
  public String csv() {
    Stream<String> head = Stream
        .of(Stream.concat(Stream.concat(Stream.of("kind", "bundle", "name"), ruics.stream()), Stream.of("used_by"))
            .map(ReuseReport::quoted).collect(Collectors.joining(",")));
    return Stream.concat(head, rows.stream().map(this::csv)).collect(Collectors.joining("\n", "", "\n"));
  }

  private String csv(Row row) {
    String cells = ruics.stream().map(r -> row.users().contains(r) ? "1" : "0").collect(Collectors.joining(","));
    return word(row.kind()) + "," + quoted(row.bundle()) + "," + quoted(row.name()) + "," + cells + ","
        + row.users().size();
  }

  private static String quoted(String text) {
    return text.matches("[A-Za-z0-9 ._-]*") ? text : '"' + text.replace("\"", "\"\"") + '"';
  }

  private static String word(Kind kind) {
    return kind.name().toLowerCase(Locale.ROOT);
  }
}
