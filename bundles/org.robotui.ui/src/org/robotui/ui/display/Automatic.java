package org.robotui.ui.display;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.robotui.api.port.Input;
import org.robotui.api.port.SourceId;

/** What is shown where nobody says it: each source that a kind takes, once. */
public final class Automatic {
  /** More of one kind are listed, but not shown. */
  public static final int MOST_SHOWN = 6;

  /** More of one kind are not listed. */
  public static final int MOST_LISTED = 24;

  private Automatic() {}

  /**
   * One for each that is offered, those that need no data first.
   *
   * @param kinds those that are there
   * @param offered what robots offer
   * @return with ids that tell them apart
   */
  public static List<DisplaySpec> displays(List<DisplayKind> kinds, List<Input.Candidate> offered) {
    List<DisplaySpec> specs = new ArrayList<>();
    Set<String> taken = new HashSet<>();
    for (DisplayKind kind : kinds.stream().filter(DisplayKind::automatic).toList()) {
      if (kind.needs().isEmpty()) {
        specs.addFirst(DisplaySpec.of(DisplayCodec.free(kind.id(), taken), kind.id()));
      } else {
        specs.addAll(each(kind, offered, taken));
      }
    }
    return List.copyOf(specs);
  }

  private static List<DisplaySpec> each(DisplayKind kind, List<Input.Candidate> offered, Set<String> taken) {
    List<SourceId> fitting = SourceChoice.fitting(kind.accepts().getFirst(), offered);
    List<DisplaySpec> specs = new ArrayList<>();
    for (SourceId source : fitting.stream().limit(MOST_LISTED).toList()) {
      String name = fitting.size() == 1 ? "" : SourceName.among(source, fitting) + " · " + kind.label();
      DisplaySpec spec = DisplaySpec.of(DisplayCodec.free(kind.id() + ':' + SourceName.of(source), taken), kind.id());
      specs.add(spec.named(name).from(List.of(SourceName.of(source))).show(specs.size() < MOST_SHOWN));
    }
    return specs;
  }
}
