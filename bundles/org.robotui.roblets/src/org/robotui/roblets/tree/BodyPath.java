package org.robotui.roblets.tree;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import java.util.IdentityHashMap;
import java.util.Collections;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A path into a tree, in words of XPath: {@code gps/position/@latitude}, {@code *}{@code /battery}, {@code //heading},
 * {@code wind[@unit='kn']/speed}, {@code leg[2]/text()}. Steps are names or {@code *}; {@code //} goes to all levels
 * below; in brackets is a number, an attribute that has to be there, or one with a value. It begins below the root.
 * Each element is found once, in the order of the tree, so that no path takes longer than its length times the size of
 * the tree.
 */
public final class BodyPath {
  private static final int MOST_STEPS = 16;
  private static final int LONGEST = 300;
  private static final Pattern STEP = Pattern.compile("(?<deep>/?)(?<name>\\*|[A-Za-z_][A-Za-z0-9_.-]*)"
      + "(?<where>(\\[(?:[1-9][0-9]{0,5}|@[A-Za-z_][A-Za-z0-9_.-]*(?:=(?:'[^']*'|\"[^\"]*\"))?)])*)(?:/|$)");
  private static final Pattern WHERE = Pattern
      .compile("\\[(?:(?<index>[0-9]+)|@(?<attribute>[^\\]='\"]+)(?:=(?:'(?<one>[^']*)'|\"(?<two>[^\"]*)\"))?)]");
  private static final Pattern VALUE = Pattern.compile("@(?<attribute>[A-Za-z_][A-Za-z0-9_.-]*)|(?<text>text\\(\\))");

  private final String written;
  private final List<Step> steps;
  private final Optional<String> attribute;

  /** One step: to children, or to all below, of a name. */
  private record Step(boolean deep, String name, List<Filter> filters) {}

  /** What an element has to be; one of both is there. */
  private record Filter(OptionalInt index, Optional<String> attribute, Optional<String> value) {}

  private BodyPath(String written, List<Step> steps, Optional<String> attribute) {
    this.written = written;
    this.steps = steps;
    this.attribute = attribute;
  }

  /**
   * Reads a path.
   *
   * @param path as above; a first {@code /} may stand before it
   * @return the path
   * @throws IllegalArgumentException where it is none; says from where on
   */
  public static BodyPath parse(String path) {
    if (path.length() > LONGEST) {
      throw new IllegalArgumentException("a path has " + LONGEST + " characters at most");
    }
    String rest = path.startsWith("/") ? path.substring(1) : path;
    List<Step> steps = new ArrayList<>();
    while (!rest.isEmpty()) {
      Matcher value = VALUE.matcher(rest);
      if (value.matches() && !steps.isEmpty()) {
        return new BodyPath(path, List.copyOf(steps), Optional.ofNullable(value.group("attribute")));
      }
      Matcher step = STEP.matcher(rest);
      if (!step.lookingAt() || steps.size() == MOST_STEPS
          || step.group().endsWith("/") && step.end() == rest.length()) {
        throw new IllegalArgumentException("'" + path + "' is no path from '" + rest
            + "' on; write names with / between, such as gps/position/@latitude, and " + MOST_STEPS + " at most");
      }
      steps.add(new Step(!step.group("deep").isEmpty(), step.group("name"), filters(step.group("where"))));
      rest = rest.substring(step.end());
    }
    if (steps.isEmpty()) {
      throw new IllegalArgumentException("a path has at least one name");
    }
    return new BodyPath(path, List.copyOf(steps), Optional.empty());
  }

  private static List<Filter> filters(String where) {
    List<Filter> all = new ArrayList<>();
    Matcher each = WHERE.matcher(where);
    while (each.find()) {
      String index = each.group("index");
      String value = each.group("one") == null ? each.group("two") : each.group("one");
      all.add(new Filter(index == null ? OptionalInt.empty() : OptionalInt.of(Integer.parseInt(index)),
          Optional.ofNullable(each.group("attribute")), Optional.ofNullable(value)));
    }
    return List.copyOf(all);
  }

  /**
   * The elements to which it leads; those that bear the attribute where it ends with one.
   *
   * @param root where to begin
   * @return in the order of the tree
   */
  public List<BodyElement> elements(BodyElement root) {
    List<BodyElement> at = List.of(root);
    for (Step step : steps) {
      Set<BodyElement> next = Collections.newSetFromMap(new IdentityHashMap<>());
      List<BodyElement> ordered = new ArrayList<>();
      for (BodyElement from : step.deep() ? below(at) : at) {
        chosen(step, from.children()).stream().filter(next::add).forEach(ordered::add);
      }
      at = ordered;
    }
    return at.stream().filter(e -> attribute.isEmpty() || e.attribute(attribute.get()).isPresent()).toList();
  }

  /** The elements themselves and all below them, each once. */
  private static List<BodyElement> below(List<BodyElement> from) {
    Set<BodyElement> seen = Collections.newSetFromMap(new IdentityHashMap<>());
    List<BodyElement> ordered = new ArrayList<>();
    from.forEach(element -> collect(element, seen, ordered));
    return ordered;
  }

  private static void collect(BodyElement element, Set<BodyElement> seen, List<BodyElement> ordered) {
    if (seen.add(element)) {
      ordered.add(element);
      element.children().forEach(child -> collect(child, seen, ordered));
    }
  }

  private static List<BodyElement> chosen(Step step, List<BodyElement> children) {
    List<BodyElement> left =
        children.stream().filter(c -> step.name().equals("*") || step.name().equals(c.name())).toList();
    for (Filter filter : step.filters()) {
      left = filter.index().isPresent()
          ? left.stream().skip(filter.index().getAsInt() - 1L).limit(1).toList()
          : left.stream().filter(e -> e.attribute(filter.attribute().orElseThrow())
              .filter(has -> filter.value().isEmpty() || filter.value().get().equals(has)).isPresent()).toList();
    }
    return left;
  }

  /**
   * The texts to which it leads: of the attribute with which it ends, else what stands in the elements.
   *
   * @param root where to begin
   * @return in the order of the tree
   */
  public List<String> values(BodyElement root) {
    return elements(root).stream()
        .map(e -> attribute.isPresent() ? e.attribute(attribute.get()).orElse("") : e.text()).toList();
  }

  /**
   * The first number to which it leads.
   *
   * @param root where to begin
   * @return none where there is no number
   */
  public OptionalDouble number(BodyElement root) {
    return values(root).stream().map(text -> BodyElement.of("number").with("value", text).number("value"))
        .filter(OptionalDouble::isPresent).mapToDouble(OptionalDouble::getAsDouble).findFirst();
  }

  /**
   * Whether two paths are written alike.
   *
   * @param other something
   * @return true where it is a path that is written like this one
   */
  @Override
  public boolean equals(Object other) {
    return other instanceof BodyPath path && path.written.equals(written);
  }

  @Override
  public int hashCode() {
    return written.hashCode();
  }

  @Override
  public String toString() {
    return written;
  }
}
