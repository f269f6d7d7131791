package org.robotui.core.internal.life;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.api.host.ExchangePreview;
import org.robotui.api.host.ExchangePreview.Line;
import org.robotui.api.host.ExchangePreview.Verdict;
import org.robotui.api.host.Match;
import org.robotui.api.host.MatchState;
import org.robotui.api.host.Problem;
import org.robotui.api.port.Port;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.match.Choice;
import org.robotui.core.internal.match.Exchange;
import org.robotui.core.internal.match.Have;
import org.robotui.core.internal.match.Matcher;
import org.robotui.core.internal.match.Supplier;
import org.robotui.core.internal.match.Want;

/** Matches as if a robot interface on trial stood in the place of the one of its id. Any thread. */
final class Preview {
  private static final String OWN = "your own choice";

  private final RuicParts ruic;
  private final Components components;
  private final Wiring wiring;
  private final RficSlot trial;

  Preview(RuicParts ruic, Components components, Wiring wiring, RficSlot trial) {
    this.ruic = ruic;
    this.components = components;
    this.wiring = wiring;
    this.trial = trial;
  }

  /** What is asked of the matcher. */
  private record Question(List<Want> wants, List<Have> haves, List<Supplier> suppliers) {
    Map<SourceId, Match> match(Map<SourceId, Choice> choices) {
      return Matcher.match(wants, haves, suppliers, choices).stream()
          .collect(Collectors.toMap(Match::port, m -> m, (a, b) -> a));
    }
  }

  static String sentences(List<Problem> problems) {
    return problems.stream().map(Problem::message).collect(Collectors.joining("; "));
  }

  ExchangePreview of(Map<SourceId, SourceId> picked, Optional<String> failure) {
    Question question = question();
    List<Match> now = wiring.matches();
    List<Match> then =
        Matcher.match(question.wants(), question.haves(), question.suppliers(), effective(question, picked));
    List<Port> offered = question.haves().stream().filter(h -> isTried(h.id())).map(Have::port).toList();
    List<Want> uncovered = Exchange.uncovered(question.wants(), now, trial.id(), offered);
    List<String> missing = uncovered.stream().map(Exchange::sentence).toList();
    return verdict(failure, missing, lines(now, then, uncovered), notes(question));
  }

  /** What the user picked, and what stands in for named connections that would lead nowhere. */
  Map<SourceId, SourceId> chosen(Map<SourceId, SourceId> picked) {
    Question question = question();
    Map<SourceId, SourceId> all = new HashMap<>();
    replacements(question)
        .forEach((port, choice) -> choice.peers().stream().findFirst().ifPresent(peer -> all.put(port, peer)));
    all.putAll(picked);
    return all;
  }

  private Question question() {
    List<RficSlot> slots = components.rfics().stream().map(s -> s.id().equals(trial.id()) ? trial : s).toList();
    List<Have> haves = slots.stream().flatMap(s -> s.offers().stream()).map(o -> new Have(o.id(), o.port())).toList();
    List<Want> wants = components.shown().stream().flatMap(s -> s.wants().stream()).toList();
    return new Question(wants, haves, slots.stream().map(RficSlot::supplier).toList());
  }

  private Map<SourceId, Choice> effective(Question question, Map<SourceId, SourceId> picked) {
    Map<SourceId, Choice> choices = new HashMap<>(wiring.choices());
    choices.putAll(replacements(question));
    picked.forEach((port, peer) -> choices.put(port, new Choice(List.of(peer), OWN)));
    return choices;
  }

  /**
   * Names differ from framework to framework: where a named port is not there, what the file names, or the only one
   * that fits, is.
   */
  private Map<SourceId, Choice> replacements(Question question) {
    Map<SourceId, Choice> named = wiring.choices();
    Map<SourceId, Match> byName = question.match(named);
    Map<SourceId, Match> byFile = question.match(Wiring.choices(ruic.config(), Map.of()));
    Map<SourceId, Match> byType = question.match(Map.of());
    Map<SourceId, Choice> found = new HashMap<>();
    named.forEach((port, choice) -> {
      if (!choice.peers().isEmpty() && choice.peers().stream().allMatch(this::isTried) && !connects(byName.get(port))) {
        Stream.of(byFile.get(port), byType.get(port)).filter(Preview::connects).filter(m -> !m.peers().isEmpty())
            .findFirst()
            .ifPresent(m -> found.put(port,
                new Choice(m.peers(), "the exchange, as " + choice.peers().getFirst() + " is not there")));
      }
    });
    return found;
  }

  private static boolean connects(Match match) {
    return match != null && match.state() == MatchState.CONNECTED;
  }

  private boolean isTried(SourceId id) {
    return id.component().equals(trial.id());
  }

  private List<Line> lines(List<Match> now, List<Match> then, List<Want> uncovered) {
    List<Line> lines = new ArrayList<>();
    for (Match after : then) {
      Match before =
          now.stream().filter(m -> m.port().equals(after.port()) && m.kind() == after.kind()).findFirst().orElse(after);
      boolean used = before.peers().stream().anyMatch(this::isTried);
      boolean concerned =
          used || Stream.concat(after.peers().stream(), after.candidates().stream()).anyMatch(this::isTried);
      boolean lost =
          used && uncovered.stream().anyMatch(w -> w.id().equals(after.port()) && w.port().kind() == after.kind());
      lines.add(new Line(before, withChosen(before, after), concerned, lost));
    }
    return lines;
  }

  /** A view that chooses its sources keeps its choice: what of it will be there, and what not. */
  private static Match withChosen(Match before, Match after) {
    boolean chooses = connects(after) && after.peers().isEmpty() && !before.peers().isEmpty();
    if (!chooses) {
      return after;
    }
    List<SourceId> there = before.peers().stream().filter(after.candidates()::contains).toList();
    List<String> absent = before.peers().stream().filter(p -> !there.contains(p)).map(SourceId::toString).toList();
    String reason = absent.isEmpty() ? "all that the view has chosen is there"
        : "not there: " + String.join(", ", absent) + "; choose again in the view";
    return new Match(after.port(), after.kind(), after.typeName(), after.arity(),
        there.isEmpty() ? MatchState.PENDING : after.state(), there, after.candidates(), reason);
  }

  private ExchangePreview verdict(Optional<String> failure, List<String> missing, List<Line> lines,
      List<String> notes) {
    Supplier supplier = trial.supplier();
    boolean up = trial.instance().filter(i -> i.linkNow().isUp()).isPresent();
    Verdict verdict = failure.isPresent() ? Verdict.FAILED
        : !up || !missing.isEmpty() && !supplier.settled() ? Verdict.PENDING
            : missing.isEmpty() ? Verdict.READY : Verdict.INCOMPLETE;
    String sentence = switch (verdict) {
      case FAILED -> failure.orElseThrow();
      case PENDING -> trial.id() + " " + supplier.status();
      case INCOMPLETE -> String.join("; ", missing);
      case READY -> "all that is used is covered";
    };
    return new ExchangePreview(verdict, sentence, trial.link(), lines, missing, notes);
  }

  private List<String> notes(Question question) {
    List<String> notes = new ArrayList<>();
    ruic.config().safety(trial.config().robot()).stopCall().map(stop -> stop.port())
        .filter(port -> isTried(port) && question.haves().stream().noneMatch(h -> h.id().equals(port)))
        .ifPresent(port -> notes
            .add("the stop call " + port + " is not there: a stop will send zero to all motion ports, and no more"));
    components.rfic(trial.id()).map(s -> s.config().robot()).filter(robot -> !robot.equals(trial.config().robot()))
        .ifPresent(robot -> notes
            .add("safety and frames will be those of " + trial.config().robot() + ", no more of " + robot));
    return notes;
  }
}
