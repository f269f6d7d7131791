package org.robotui.uic.scene3d.internal.model;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.Input;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.Framed;
import org.robotui.data.joint.RobotDescription;
import org.robotui.gl.display.ColorScale;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.display.DisplayType;
import org.robotui.gl.shape.Part;
import org.robotui.ui.Health;
import org.robotui.ui.StateView;
import org.robotui.ui.display.DisplayRow;
import org.robotui.ui.display.DisplaySpec;
import org.robotui.ui.display.KindSettings;
import org.robotui.ui.display.SourceChoice;
import org.robotui.ui.display.SourceName;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** One display while the scene runs: made when it is shown and its kind is there, ended when not. Worker thread. */
final class DisplaySlot {
  private static final Logger LOG = LoggerFactory.getLogger(DisplaySlot.class);
  private static final DisplayResult NOTHING = DisplayResult.nothing(new DisplayStatus.NoData(""));

  /** What a display is made of and still runs on; another kind object is another bundle. */
  private record Running(DisplayType type, Display display) {}

  private final List<Envelope<? extends Data>> arrived = new ArrayList<>();
  private DisplaySpec spec;
  private Optional<Running> running = Optional.empty();
  private Optional<DisplayType> type = Optional.empty();
  private Optional<String> fault = Optional.empty();
  private Optional<KindSettings> settings = Optional.empty();
  private SourceChoice choice = SourceChoice.NONE;
  private Set<SourceId> also = Set.of();
  private DisplayResult result = NOTHING;
  private InputState state = new InputState.Live(0, 0);
  private Optional<String> robot = Optional.empty();
  private List<String> choices = List.of();
  private long bytes;

  DisplaySlot(DisplaySpec spec) {
    this.spec = spec;
  }

  DisplaySpec spec() {
    return spec;
  }

  SourceChoice choice() {
    return choice;
  }

  /** All streams that it takes. */
  Set<SourceId> taken() {
    Set<SourceId> all = new HashSet<>(choice.sources());
    all.addAll(also);
    return all;
  }

  /** What its colours mean. */
  Optional<ColorScale> colors() {
    return result.parts().isEmpty() ? Optional.empty() : running.flatMap(r -> r.display().colors());
  }

  DisplayResult result() {
    return result;
  }

  Optional<String> robot() {
    return robot;
  }

  /** Takes what the settings and the bundles say now. */
  void configure(DisplaySpec next, Optional<DisplayType> kind, List<Input.Candidate> offered) {
    boolean again = !spec.shown() && next.shown();
    boolean renewed = again || !next.settings().equals(spec.settings()) || !next.sources().equals(spec.sources());
    fault = fault.filter(f -> !renewed);
    if (settings.isEmpty() || !next.settings().equals(spec.settings()) || kind.orElse(null) != type.orElse(null)) {
      settings = kind.map(k -> KindSettings.check(k.schema(), next.settings()));
    }
    if (running.isPresent() && running.map(Running::type).orElse(null) != kind.orElse(null)) {
      end();
      fault = Optional.empty();
    }
    spec = next;
    type = kind;
    choice = kind.map(k -> SourceChoice.of(next, Kinds.of(k), offered)).orElse(SourceChoice.NONE);
    also = kind.map(k -> k.also(settings.orElseThrow().settings())).orElse(Set.of());
    choices = kind
        .map(k -> k.accepts().stream().flatMap(a -> SourceChoice.fitting(a, offered).stream()).map(SourceName::of)
            .distinct().toList())
        .orElse(List.of());
    if (!wanted()) {
      end();
    }
  }

  /** Whether it is to run. */
  boolean wanted() {
    return spec.shown() && type.isPresent() && fault.isEmpty();
  }

  void take(Envelope<Data> envelope) {
    arrived.add(envelope);
    if (robot.isEmpty() && choice.sources().contains(envelope.source())) {
      robot = robotOf(envelope.value());
    }
  }

  private static Optional<String> robotOf(Data value) {
    return switch (value) {
      case RobotDescription description -> Optional.of(description.robot());
      case Framed framed -> framed.frames().findFirst().map(FrameId::robot);
      default -> Optional.empty();
    };
  }

  /** Updates it; true where something else is to be seen. */
  boolean update(DisplayContext context, Input<Data> input, SlotTick tick) {
    List<Part> before = result.parts();
    if (wanted()) {
      try {
        state = choice.state(input.sources(), input::state);
        result = running(context).display().update(tick.of(
            arrived, state, settings.orElseThrow().settings()));
        PartsCheck.distinct(result.parts());
      } catch (RuntimeException | LinkageError e) {
        fail(e);
      }
    }
    arrived.clear();
    boolean changed = !PartsCheck.same(before, result.parts());
    bytes = changed ? PartsCheck.bytes(result.parts()) : bytes;
    return changed;
  }

  void end() {
    running.ifPresent(r -> {
      try {
        r.display().close();
      } catch (RuntimeException | LinkageError e) {
        LOG.warn("The display {} failed while it was ended", spec.id(), e);
      }
    });
    running = Optional.empty();
    result = NOTHING;
    arrived.clear();
  }

  DisplayRow row() {
    String name = spec.name().isEmpty() ? type.map(DisplayType::label).orElse(spec.type()) : spec.name();
    return new DisplayRow(spec, name, health(), words(), spec.shown() ? bytes : 0, result.dropped(),
        settings.map(KindSettings::settings), choices);
  }

  private Running running(DisplayContext context) {
    if (running.isEmpty()) {
      DisplayType made = type.orElseThrow();
      running = Optional.of(new Running(made, made.create(context)));
    }
    return running.get();
  }

  private void fail(Throwable e) {
    LOG.warn("The display {} of kind {} failed and is switched off", spec.id(), spec.type(), e);
    end();
    fault = Optional.of(e.getMessage() == null ? e.getClass().getSimpleName() : e.getMessage());
  }

  private Health health() {
    if (type.isEmpty()) {
      return spec.shown() ? Health.WAITING : Health.NONE;
    }
    if (fault.isPresent()) {
      return Health.BAD;
    }
    if (!spec.shown()) {
      return Health.NONE;
    }
    if (!choice.problem().isEmpty() && result.parts().isEmpty()) {
      return Health.WAITING;
    }
    return switch (status()) {
      case DisplayStatus.Shown s -> settings.filter(k -> !k.problems().isEmpty()).isPresent() ? Health.WARNING
          : Health.OK;
      case DisplayStatus.Partly p -> Health.WARNING;
      case DisplayStatus.NoData n -> Health.WAITING;
      case DisplayStatus.NoFrame n -> Health.WARNING;
      case DisplayStatus.TooOld t -> Health.STALE;
      case DisplayStatus.Unfit u -> Health.BAD;
    };
  }

  /** Whatever a display makes of it: what nothing newer can come of is not shown as if it were true. */
  private DisplayStatus status() {
    boolean seen = result.status() instanceof DisplayStatus.Shown || result.status() instanceof DisplayStatus.TooOld;
    return seen && state instanceof InputState.Stale old && old.lostSeconds().isPresent()
        ? new DisplayStatus.TooOld(StateView.sentence(old))
        : result.status();
  }

  private String words() {
    if (type.isEmpty()) {
      return "waits for a bundle that brings displays of type '" + spec.type() + "'";
    }
    if (fault.isPresent()) {
      return "failed and was switched off: " + fault.get() + "; switch it off and on to try again";
    }
    if (!spec.shown()) {
      return "switched off";
    }
    List<String> wrong = settings.map(KindSettings::problems).orElse(List.of());
    if (!wrong.isEmpty()) {
      return wrong.getFirst();
    }
    return !choice.problem().isEmpty() && result.parts().isEmpty() ? choice.problem() : status().words();
  }
}
