package org.robotui.ui.layer;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.robotui.api.port.Input;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.ui.display.Automatic;
import org.robotui.ui.display.DisplayCodec;
import org.robotui.ui.display.DisplaySpec;
import org.robotui.ui.display.SourceChoice;
import org.robotui.ui.display.SourceName;

/** What is shown beside what is listed: each source that a kind takes and no layer of that kind has, once. */
record LayerOffers(List<LayerType> types, Map<String, LayerType> byId, List<Input.Candidate> offered,
    Predicate<Class<? extends Data>> hasPort,
    LayerStack.Rules rules) {

  /** The list with what is offered, each of it where its kind begins in the stack; topmost first. */
  List<DisplaySpec> beside(List<DisplaySpec> written) {
    List<DisplaySpec> all = new ArrayList<>(written);
    Set<String> taken = written.stream().map(DisplaySpec::id).collect(Collectors.toCollection(HashSet::new));
    for (LayerType type : types.stream().filter(LayerType::automatic).sorted(LayerStack.topmost()).toList()) {
      for (DisplaySpec spec : offers(type)) {
        if (written.stream().noneMatch(w -> covers(w, spec))) {
          DisplaySpec begun = rules.begin(spec);
          all.add(place(all, type),
              new DisplaySpec(DisplayCodec.free(begun.id(), taken), begun.type(), begun.name(), begun.sources(),
                  begun.shown(), begun.settings()));
        }
      }
    }
    return List.copyOf(all);
  }

  /** Above the first that begins lower. */
  private int place(List<DisplaySpec> all, LayerType type) {
    for (int i = 0; i < all.size(); i++) {
      int level = Optional.ofNullable(byId.get(all.get(i).type())).map(LayerType::level).orElse(Integer.MAX_VALUE);
      boolean sameKind = all.get(i).type().equals(type.id());
      if (level < type.level() || sameKind) {
        return i;
      }
    }
    return all.size();
  }

  private static boolean covers(DisplaySpec written, DisplaySpec offered) {
    return written.id().equals(offered.id())
        || written.type().equals(offered.type())
            && (written.sources().isEmpty() || written.sources().stream().anyMatch(offered.sources()::contains));
  }

  private List<DisplaySpec> offers(LayerType type) {
    if (type.needs().isEmpty()) {
      return List.of(DisplaySpec.of(type.id(), type.id()));
    }
    List<SourceId> fitting = SourceChoice.fitting(type.accepts().getFirst(), offered);
    boolean bounded = !hasPort.test(type.accepts().getFirst());
    List<DisplaySpec> specs = new ArrayList<>();
    for (SourceId source : fitting.stream().limit(bounded ? Automatic.MOST_LISTED : fitting.size()).toList()) {
      String name = fitting.size() == 1 ? "" : SourceName.among(source, fitting) + " · " + type.label();
      specs.add(DisplaySpec.of(type.id() + ":" + source, type.id()).named(name).from(List.of(SourceName.of(source)))
          .show(!bounded || specs.size() < Automatic.MOST_SHOWN));
    }
    return specs;
  }
}
