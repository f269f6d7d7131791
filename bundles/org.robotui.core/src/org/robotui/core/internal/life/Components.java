package org.robotui.core.internal.life;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.robotui.api.command.Authority;
import org.robotui.core.internal.command.CommandTarget;
import org.robotui.core.internal.config.model.ComponentConfig;
import org.robotui.core.internal.port.CallTarget;
import org.robotui.core.internal.port.StreamSource;

/** All components of one RUIC. Changed on its worker only, read by all. */
final class Components {
  private static final Duration CLOSE_LIMIT = Duration.ofSeconds(2);

  private final RuicParts ruic;
  private volatile List<RficSlot> rfics = List.of();
  private volatile List<UicSlot> uics = List.of();

  Components(RuicParts ruic) {
    this.ruic = ruic;
  }

  /** Creates and starts all: robot interfaces first, so that views find their ports. */
  void start(List<ComponentConfig> interfaces, List<ComponentConfig> views, Supplier<Authority> authority) {
    rfics = interfaces.stream().map(c -> new RficSlot(c, ruic)).toList();
    uics = views.stream().map(c -> new UicSlot(c, authority, ruic)).toList();
    rfics.forEach(Slot::start);
    shown().forEach(Slot::start);
  }

  /**
   * Ends the views that are not wanted any more, at the same time, and starts those that are new; all others go on.
   * Returns what could not be ended.
   */
  List<String> rearrange(List<ComponentConfig> views, Supplier<Authority> authority) {
    Map<String, UicSlot> there = new LinkedHashMap<>();
    uics.forEach(slot -> there.put(slot.id(), slot));
    List<UicSlot> next = views.stream().map(view -> Optional.ofNullable(there.remove(view.id()))
        .orElseGet(() -> new UicSlot(view, authority, ruic))).toList();
    List<UicSlot> fresh = next.stream().filter(slot -> !uics.contains(slot)).toList();
    List<Instance> ending = there.values().stream().<Instance>flatMap(s -> s.instance().stream()).toList();
    uics = next;
    List<String> left = endViews(List.copyOf(there.values()));
    left.addAll(ending.isEmpty() ? List.of() : ruic.strays(ending));
    fresh.stream().filter(UicSlot::isShown).forEach(Slot::start);
    return left;
  }

  private List<String> endViews(List<UicSlot> views) {
    try {
      return new ArrayList<>(closeAll(views, CLOSE_LIMIT));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return new ArrayList<>(List.of("ending views was interrupted"));
    }
  }

  /** Puts another robot interface, which does not run yet, in the place of the one of its id, which has ended. */
  RficSlot replace(ComponentConfig next) {
    RficSlot slot = new RficSlot(next, ruic);
    rfics = rfics.stream().map(s -> s.id().equals(next.id()) ? slot : s).toList();
    return slot;
  }

  /** A robot interface by its id. */
  Optional<RficSlot> rfic(String id) {
    return rfics.stream().filter(s -> s.id().equals(id)).findFirst();
  }

  /**
   * Ends all: views first, so that nobody commands any more; robot interfaces at the same time. Returns what is left.
   */
  List<String> close(Duration limit) throws InterruptedException {
    List<UicSlot> views = uics;
    List<RficSlot> interfaces = rfics;
    List<Instance> ending =
        Stream.concat(views.stream(), interfaces.stream()).<Instance>flatMap(s -> s.instance().stream()).toList();
    long end = System.nanoTime() + limit.toNanos();
    Duration half = limit.dividedBy(2);
    List<String> left = new ArrayList<>(closeAll(views, half));
    Duration rest = Duration.ofNanos(end - System.nanoTime());
    left.addAll(closeAll(interfaces, rest.compareTo(half) > 0 ? rest : half));
    left.addAll(ruic.strays(ending));
    uics = List.of();
    rfics = List.of();
    return left;
  }

  private List<String> closeAll(List<? extends Slot<?, ?>> slots, Duration limit) throws InterruptedException {
    ConcurrentLinkedQueue<String> left = new ConcurrentLinkedQueue<>();
    List<Runnable> works = new ArrayList<>();
    slots.stream().filter(s -> s.instance().isPresent())
        .forEach(s -> works.add(() -> s.end(limit).ifPresent(left::add)));
    Guarded.all(ruic.threads(), works);
    return List.copyOf(left);
  }

  /** Takes up that types have come or gone. True where something has changed. */
  boolean typesChanged() {
    return all().map(Slot::typesChanged).reduce(false, Boolean::logicalOr);
  }

  /** The component of an instance failed while it ran. */
  boolean failed(Object instance, String reason) {
    Optional<Slot<?, ?>> slot = find(s -> s.instance().filter(i -> i == instance).isPresent());
    slot.ifPresent(s -> s.giveUp(reason));
    return slot.isPresent();
  }

  /** A component by its id. */
  Optional<Slot<?, ?>> find(String id) {
    return find(s -> s.id().equals(id));
  }

  private Optional<Slot<?, ?>> find(Predicate<Slot<?, ?>> which) {
    return all().filter(which).findFirst();
  }

  private Stream<Slot<?, ?>> all() {
    return Stream.<Slot<?, ?>>concat(rfics.stream(), shown().stream());
  }

  List<RficSlot> rfics() {
    return rfics;
  }

  /** The views that can be shown where this application shows views. */
  List<UicSlot> shown() {
    return uics.stream().filter(UicSlot::isShown).toList();
  }

  Optional<UicSlot> uic(String id) {
    return shown().stream().filter(s -> s.id().equals(id)).findFirst();
  }

  /** Gives up a view whose surface failed; answers whether there is such a view. */
  boolean surfaceFailed(String id, String reason) {
    Optional<UicSlot> slot = uic(id);
    slot.ifPresent(s -> s.giveUp(reason + s.instance().map(i -> " (" + i.origin() + ")").orElse("")));
    return slot.isPresent();
  }

  /** The command ports to one robot. */
  List<CommandTarget<?>> commands(String robot) {
    return rfics.stream().filter(s -> s.config().robot().equals(robot))
        .flatMap(s -> s.instance().stream()).flatMap(i -> i.table().commands().stream())
        .<CommandTarget<?>>map(c -> c).toList();
  }

  /** The streams of one robot. */
  List<StreamSource<?>> streams(String robot) {
    return rfics.stream().filter(s -> s.config().robot().equals(robot))
        .flatMap(s -> s.instance().stream()).flatMap(i -> i.table().list().stream())
        .<StreamSource<?>>mapMulti((o, out) -> {
          if (o instanceof StreamSource<?> s) {
            out.accept(s);
          }
        }).toList();
  }

  /** The call ports of one robot. */
  List<CallTarget<?, ?>> calls(String robot) {
    return rfics.stream().filter(s -> s.config().robot().equals(robot))
        .flatMap(s -> s.instance().stream()).flatMap(i -> i.table().calls().stream())
        .<CallTarget<?, ?>>map(c -> c).toList();
  }
}
