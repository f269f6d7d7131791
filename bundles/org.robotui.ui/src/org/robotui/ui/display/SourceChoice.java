package org.robotui.ui.display;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.robotui.api.port.Input;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.data.DataType;

/**
 * Where one of a list takes its data from.
 *
 * @param sources all that it takes
 * @param needed those of types that it needs
 * @param problem why it gets nothing of a type that it needs; empty where all is well
 */
public record SourceChoice(Set<SourceId> sources, Set<SourceId> needed, String problem) {
  private static final int MOST_NAMED = 6;

  /** Before anything is known. */
  public static final SourceChoice NONE = new SourceChoice(Set.of(), Set.of(), "");

  /**
   * Copies the sets.
   *
   * @param sources all
   * @param needed those that it needs
   * @param problem what is missing
   */
  public SourceChoice {
    sources = Set.copyOf(sources);
    needed = Set.copyOf(needed);
  }

  /**
   * Chooses: what is named; else the only one that fits, of the robot that the named ones belong to where several do.
   *
   * @param spec what is written
   * @param type its kind
   * @param offered what there is
   * @return where its data come from
   */
  public static SourceChoice of(DisplaySpec spec, DisplayKind type, List<Input.Candidate> offered) {
    Set<SourceId> sources = new LinkedHashSet<>();
    Set<SourceId> needed = new LinkedHashSet<>();
    List<String> problems = new ArrayList<>();
    Set<String> components = new LinkedHashSet<>();
    type.accepts().forEach(data -> named(spec, fitting(data, offered)).forEach(s -> components.add(s.component())));
    for (Class<? extends Data> data : type.accepts()) {
      boolean must = type.needs().contains(data);
      List<SourceId> fitting = fitting(data, offered);
      List<SourceId> taken = taken(spec, fitting, components, must, type.needs().isEmpty());
      sources.addAll(taken);
      taken.forEach(s -> components.add(s.component()));
      if (must) {
        needed.addAll(taken);
        if (taken.isEmpty()) {
          problems.add(why(spec, DataType.of(data).name(), fitting));
        }
      }
    }
    return new SourceChoice(sources, needed, problems.isEmpty() ? "" : problems.getFirst());
  }

  /**
   * How its sources are: the best of those that it needs.
   *
   * @param there those that are connected
   * @param states gives the state of one of them
   * @return the state; live where it needs none
   */
  public InputState state(Collection<SourceId> there, Function<SourceId, InputState> states) {
    if (!problem.isEmpty()) {
      return new InputState.Unconnected(problem);
    }
    return (needed.isEmpty() ? sources : needed).stream()
        .map(s -> there.contains(s) ? states.apply(s) : new InputState.Waiting("asking for " + SourceName.of(s)))
        .min(Comparator.comparingInt(SourceChoice::rank)).orElse(new InputState.Live(0, 0));
  }

  private static int rank(InputState state) {
    return switch (state) {
      case InputState.Live l -> 0;
      case InputState.Stale s -> 1;
      case InputState.Waiting w -> 2;
      case InputState.Failed f -> 3;
      case InputState.Unconnected u -> 4;
    };
  }

  /**
   * The sources that fit a type of data.
   *
   * @param data the type; an interface fits what is of the same package
   * @param offered what there is
   * @return the sources in the order of the offer
   */
  public static List<SourceId> fitting(Class<? extends Data> data, List<Input.Candidate> offered) {
    String name = DataType.of(data).name();
    return offered.stream().filter(c -> c.typeName().equals(name) || isA(data, c.typeName())).map(Input.Candidate::id)
        .toList();
  }

  /**
   * Whether a type of the same package is one of a general type: a display of pictures takes raw and compressed ones.
   */
  private static boolean isA(Class<? extends Data> data, String typeName) {
    if (!data.isInterface()) {
      return false;
    }
    try {
      return data.isAssignableFrom(Class.forName(data.getPackageName() + '.' + typeName, false, data.getClassLoader()));
    } catch (ClassNotFoundException e) {
      return false;
    }
  }

  private static List<SourceId> taken(DisplaySpec spec, List<SourceId> fitting, Set<String> components, boolean must,
      boolean needsNone) {
    List<SourceId> named = named(spec, fitting);
    if (!named.isEmpty()) {
      return named;
    }
    if (needsNone && spec.sources().isEmpty()) {
      return fitting;
    }
    List<SourceId> ofThese = fitting.stream().filter(s -> components.contains(s.component())).toList();
    List<SourceId> likely = ofThese.isEmpty() ? fitting : ofThese;
    boolean clear = likely.size() == 1 && (spec.sources().isEmpty() || !components.isEmpty());
    return clear || !must && !components.isEmpty() ? likely : List.of();
  }

  private static List<SourceId> named(DisplaySpec spec, List<SourceId> fitting) {
    return fitting.stream().filter(s -> spec.sources().stream().anyMatch(w -> SourceName.fits(w, s))).toList();
  }

  private static String why(DisplaySpec spec, String data, List<SourceId> fitting) {
    String there = fitting.stream().limit(MOST_NAMED).map(SourceName::of).collect(Collectors.joining(", "))
        + (fitting.size() > MOST_NAMED ? ", \u2026" : "");
    if (fitting.isEmpty()) {
      return "no " + data + " is offered: is its node running, and its robot interface connected?";
    }
    return spec.sources().isEmpty() ? "several give " + data + ", choose one as source: " + there
        : String.join(", ", spec.sources()) + " is not there; " + data + " comes from " + there;
  }
}
