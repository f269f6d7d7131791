package org.robotui.core.internal.life;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.robotui.api.UicType;
import org.robotui.api.UicType.Surface;
import org.robotui.api.host.Arranging;
import org.robotui.api.host.ViewFit;
import org.robotui.api.layout.Arrangement;
import org.robotui.api.layout.Arrangement.Added;
import org.robotui.core.internal.config.Checksum;
import org.robotui.core.internal.config.model.ComponentConfig;
import org.robotui.core.internal.config.model.KeptViews;
import org.robotui.core.internal.config.model.KeptViews.Hand;

/**
 * The views of one RUIC as they are arranged. What is arranged holds at once for those who ask; the views that come and
 * go do so on the RUIC's worker.
 */
final class ArrangedViews implements Arranging {
  private static final int LONGEST_NAME = 60;

  private final RuicParts ruic;
  private final Wiring wiring;
  private final Runnable changed;
  private volatile ArrangedPlan plan;
  private volatile Arrangement now;

  /**
   * Of a RUIC that has not been planned yet.
   *
   * @param ruic its parts
   * @param wiring knows what its robots offer
   * @param changed has the views run that {@link #running} says, soon, and applications told
   */
  ArrangedViews(RuicParts ruic, Wiring wiring, Runnable changed) {
    this.ruic = ruic;
    this.wiring = wiring;
    this.changed = changed;
    this.plan = ArrangedPlan.none(ruic.config().layout(), ruic.services().check().nothing());
    this.now = plan.written();
  }

  /** Takes up what is planned; from then on it holds, as the user has arranged it. */
  void plan(Plan next) {
    plan = new ArrangedPlan(next.uics(), new Arrangement(next.layout()), ruic.services().check().nothing());
    now = kept().map(plan::merged).orElse(plan.written());
  }

  /** The views that run now. */
  List<ComponentConfig> running() {
    return plan.running(now, this::needsPlace);
  }

  /** A file that has another layout than when the user arranged the views is newer. */
  private Optional<Hand> kept() {
    Optional<Hand> kept = ruic.overlay().views().arrangement();
    if (kept.filter(hand -> !hand.insteadOf().equals(mark())).isPresent()) {
      keep(Optional.empty());
      ruic.services().events().alert(ruic.ruicName(), "The layout of " + ruic.ruicName()
          + " has changed in its configuration, which holds now instead of what you had arranged.");
      return Optional.empty();
    }
    return kept;
  }

  private String mark() {
    return ruic.config().layout().map(layout -> Checksum.of(layout.toString())).orElse("");
  }

  private boolean needsPlace(ComponentConfig view) {
    return type(view).filter(type -> type.surface() == Surface.WINDOW).isPresent() || now.views().contains(view.id());
  }

  private Optional<UicType> type(ComponentConfig view) {
    return ruic.services().registry().uic(view.type());
  }

  @Override
  public Arrangement now() {
    return now;
  }

  @Override
  public Arrangement written() {
    return plan.written();
  }

  @Override
  public void arrange(Arrangement wanted) {
    Arrangement next = plan.possible(wanted);
    if (!next.equals(now)) {
      now = next;
      keep(Optional.of(new Hand(next, plan.ids(next.added()), mark())));
      changed.run();
    }
  }

  /** The id of a view of a type that is closed, else one for one more. */
  String closed(String type) {
    return views().stream().filter(view -> !view.open() && view.type().equals(type)).map(ViewChoice::id).findFirst()
        .orElseGet(() -> freshId(type));
  }

  /** Opens a view that is closed, or one more of a type; one that is open stays where it is. */
  void open(String id, String type) {
    Arrangement before = now;
    boolean known = plan.placeable(before, this::needsPlace).anyMatch(view -> view.id().equals(id));
    if (!before.views().contains(id)) {
      arrange((known ? before : before.adding(new Added(id, type))).opened(id, plan.written().layout()));
    }
  }

  @Override
  public void reset() {
    now = plan.written();
    keep(Optional.empty());
    changed.run();
  }

  private void keep(Optional<Hand> hand) {
    ruic.overlay().arrange(old -> new KeptViews(hand, old.perspectives(), old.perspective()));
  }

  @Override
  public List<ViewChoice> views() {
    Arrangement shown = now;
    return plan.placeable(shown, this::needsPlace)
        .map(view -> new ViewChoice(view.id(), view.type(), title(view), shown.views().contains(view.id()))).toList();
  }

  private String title(ComponentConfig view) {
    return UicSlot.title(view, type(view));
  }

  /** What users call a view. */
  Optional<String> title(String id) {
    return plan.placeable(now, view -> view.id().equals(id)).findFirst().map(this::title);
  }

  @Override
  public List<ViewFit> types() {
    return wiring.fits(ruic.services().registry().uics());
  }

  @Override
  public String freshId(String type) {
    Set<String> taken = plan.ids(now.added());
    return FreshName.of(type, type + "-", id -> !taken.contains(id) && ruic.config().rfic(id).isEmpty()
        && ruic.overlay().settings(id).isEmpty());
  }

  @Override
  public Map<String, Perspective> perspectives() {
    Map<String, Perspective> all = new TreeMap<>();
    ruic.config().perspectives()
        .forEach((name, layout) -> all.put(name, new Perspective(new Arrangement(layout), true)));
    ruic.overlay().views().perspectives()
        .forEach((name, arrangement) -> all.put(name, new Perspective(arrangement, false)));
    return all;
  }

  @Override
  public Optional<String> perspective() {
    return ruic.overlay().views().perspective().filter(perspectives()::containsKey);
  }

  @Override
  public void keep(String name) {
    checked(name);
    keep(name, now, true);
    changed.run();
  }

  private static void checked(String name) {
    if (name.isBlank() || name.length() > LONGEST_NAME || name.chars().anyMatch(Character::isISOControl)) {
      throw new IllegalArgumentException("a perspective has a name of 1 to " + LONGEST_NAME + " characters");
    }
  }

  @Override
  public void rename(String name, String next) {
    checked(next);
    if (perspectives().containsKey(next)) {
      throw new IllegalArgumentException("there is a perspective '" + next + "' already");
    }
    ruic.overlay().arrange(old -> {
      Map<String, Arrangement> named = new LinkedHashMap<>(old.perspectives());
      Optional.ofNullable(named.remove(name)).ifPresent(arrangement -> named.put(next, arrangement));
      return new KeptViews(old.arrangement(), named, old.perspective().map(n -> n.equals(name) ? next : n));
    });
    changed.run();
  }

  /** Keeps a perspective, which then may be the present one. */
  void keep(String name, Arrangement arrangement, boolean chosen) {
    ruic.overlay().arrange(old -> {
      Map<String, Arrangement> named = new LinkedHashMap<>(old.perspectives());
      named.put(name, arrangement);
      return new KeptViews(old.arrangement(), named, chosen ? Optional.of(name) : old.perspective());
    });
  }

  @Override
  public void choose(String name) {
    Optional.ofNullable(perspectives().get(name)).ifPresent(perspective -> {
      ruic.overlay().arrange(old -> new KeptViews(old.arrangement(), old.perspectives(), Optional.of(name)));
      arrange(perspective.arrangement());
      changed.run();
    });
  }

  @Override
  public void forget(String name) {
    ruic.overlay().arrange(old -> {
      Map<String, Arrangement> named = new LinkedHashMap<>(old.perspectives());
      named.remove(name);
      return new KeptViews(old.arrangement(), named, old.perspective().filter(n -> !n.equals(name)));
    });
    changed.run();
  }

  @Override
  public Optional<String> export(String name) {
    return Optional.ofNullable(perspectives().get(name))
        .map(perspective -> new PerspectiveExchange(ruic, plan, this).text(name, perspective.arrangement()));
  }

  @Override
  public PerspectiveImport take(String text) {
    PerspectiveImport taken = new PerspectiveExchange(ruic, plan, this).take(text);
    changed.run();
    return taken;
  }
}
