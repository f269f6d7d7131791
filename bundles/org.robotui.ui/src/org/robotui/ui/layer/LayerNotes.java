package org.robotui.ui.layer;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.ui.Health;
import org.robotui.ui.StateView;

/**
 * What is wrong with layers, those of a kind with the same trouble in one line; nothing of those that are well or
 * hidden.
 */
final class LayerNotes {
  /** As many layers of the same trouble have a line each. */
  private static final int MOST_APART = 2;

  private enum Trouble {
    FAILED("failed"), WAITING("wait for data"), REFUSED("sent what was refused"), UNPLACED("without a transform"),
    STALE("stale");

    final String words;

    Trouble(String words) {
      this.words = words;
    }
  }

  private LayerNotes() {}

  static List<LayerNote> of(List<LayerSlot> slots) {
    Map<LayerType, List<LayerSlot>> kinds = new LinkedHashMap<>();
    slots.forEach(slot -> slot.type().ifPresent(type -> kinds.computeIfAbsent(type, t -> new ArrayList<>()).add(slot)));
    List<LayerNote> notes = new ArrayList<>();
    kinds.forEach((type, all) -> notes.addAll(of(type, all)));
    return List.copyOf(notes);
  }

  private static List<LayerNote> of(LayerType type, List<LayerSlot> slots) {
    Map<Trouble, List<LayerNote>> troubled = new EnumMap<>(Trouble.class);
    for (LayerSlot slot : slots) {
      trouble(type, slot)
          .ifPresent(t -> troubled.computeIfAbsent(t, n -> new ArrayList<>()).add(note(type, slots, slot, t)));
    }
    List<LayerNote> notes = new ArrayList<>();
    troubled.forEach((trouble, each) -> {
      if (each.size() <= MOST_APART) {
        notes.addAll(each);
      } else {
        String example = trouble == Trouble.STALE ? "" : ", for example " + each.getFirst().text();
        notes.add(new LayerNote(each.getFirst().health(),
            type.data() + ": " + each.size() + " of " + slots.size() + " " + trouble.words + example));
      }
    });
    return notes;
  }

  private static Optional<Trouble> trouble(LayerType type, LayerSlot slot) {
    if (slot.failed().isPresent()) {
      return Optional.of(Trouble.FAILED);
    }
    if (!slot.wanted() || slot.choice().sources().isEmpty()) {
      return Optional.empty();
    }
    return switch (slot.state()) {
      case InputState.Failed f -> Optional.of(Trouble.FAILED);
      case InputState.Waiting w -> type.occasional() ? Optional.empty() : Optional.of(Trouble.WAITING);
      case InputState.Stale s when s.refused() -> Optional.of(Trouble.REFUSED);
      case InputState s when slot.status() instanceof LayerStatus.NoFrame -> Optional.of(Trouble.UNPLACED);
      case InputState.Stale s -> Optional.of(Trouble.STALE);
      default -> Optional.empty();
    };
  }

  private static LayerNote note(LayerType type, List<LayerSlot> slots, LayerSlot slot, Trouble trouble) {
    InputState state = slot.state();
    String source = source(slots, slot);
    boolean named = slots.size() > 1 && !(trouble == Trouble.WAITING && state.explanation().startsWith(source));
    String name = type.data() + (named ? " " + source : "");
    return switch (trouble) {
      case FAILED -> new LayerNote(Health.BAD, name + ": " + slot.failed().orElseGet(state::explanation));
      case WAITING -> new LayerNote(StateView.health(state), name + ": " + state.explanation());
      case REFUSED -> new LayerNote(Health.WARNING, name + ": " + state.explanation());
      case UNPLACED -> new LayerNote(Health.WARNING, name + ": " + slot.status().words());
      case STALE -> new LayerNote(Health.STALE,
          name + " " + (state instanceof InputState.Stale old ? StateView.sentence(old) : StateView.word(state)));
    };
  }

  /** Ports of several robot interfaces may have the same name. */
  private static String source(List<LayerSlot> slots, LayerSlot slot) {
    boolean several =
        slots.stream().flatMap(s -> s.choice().sources().stream()).map(SourceId::component).distinct().count() > 1;
    return slot.choice().sources().stream().findFirst().map(id -> several ? id.toString() : id.port())
        .orElse(slot.name());
  }
}
