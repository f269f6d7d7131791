package org.robotui.core.internal.life;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.api.Uic;
import org.robotui.api.UicType;
import org.robotui.api.command.Authority;
import org.robotui.api.config.Settings;
import org.robotui.api.config.SettingsStore;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.RuicState;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.config.model.ComponentConfig;
import org.robotui.core.internal.match.Want;

/** The place of one view. */
final class UicSlot extends Slot<UicType, UicInstance> {
  private final Supplier<Authority> authority;
  private final RuicParts parts;
  private final Revival revival = new Revival();
  private Optional<UicInstance> late = Optional.empty();
  private volatile boolean shown = true;

  UicSlot(ComponentConfig config, Supplier<Authority> authority, RuicParts ruic) {
    super(config, ruic);
    this.authority = authority;
    this.parts = ruic;
  }

  @Override
  void restart() {
    revival.begin();
    super.restart();
  }

  /** An instance took too long, or still does: it ends, and its successor goes on with what it retained. */
  void endLate(String sentence, UicInstance instance) {
    endLate(sentence);
    late = Optional.of(instance);
  }

  /** When it is started again after it took too long. */
  Revival revival() {
    return revival;
  }

  @Override
  Optional<UicType> find() {
    return ruic().services().registry().uic(config().type());
  }

  @Override
  String missing() {
    return ruic().services().registry().missingUic(config().type());
  }

  @Override
  UicInstance make(UicType of, Settings settings) {
    Optional<UicInstance> before = late.filter(instance -> instance.type().equals(of));
    late = Optional.empty();
    return new UicInstance(config(), of, settings, authority, parts, before.flatMap(UicInstance::retain));
  }

  /** False where its type is, or was when it was last there, for another surface than the application has. */
  boolean isShown() {
    find().ifPresent(t -> shown = ruic().services().stage().get().shows(t.surface()));
    return shown;
  }

  /** The ports that want to be connected. */
  List<Want> wants() {
    return instance().map(i -> i.type().ports().stream()
        .map(p -> new Want(new SourceId(id(), p.name()), p)).toList()).orElse(List.of());
  }

  void select(boolean selected) {
    instance().ifPresent(i -> i.select(selected));
  }

  Optional<Uic> uic() {
    return instance().flatMap(UicInstance::made);
  }

  long ticks() {
    return instance().map(UicInstance::ticks).orElse(0L);
  }

  Optional<SettingsStore> settings() {
    return instance().map(UicInstance::settings);
  }

  String title() {
    return title(config(), find());
  }

  /** What users call a view. One that was added is called after its type; the second one of a type says so. */
  static String title(ComponentConfig view, Optional<UicType> type) {
    String label = type.map(UicType::label).orElse(view.id());
    String number = view.id().startsWith(view.type() + "-") ? view.id().substring(view.type().length() + 1) : "";
    return !view.title().isEmpty() ? view.title() : number.matches("[0-9]+") ? label + " " + number : label;
  }

  ComponentStatus status(RuicState ruicState) {
    Health now = health();
    RuicState state = now.state() == RuicState.INITIALIZED ? ruicState : now.state();
    return new ComponentStatus(
        id(), config().type(), ComponentStatus.Kind.UIC, state, now.reason(), Optional.empty());
  }
}
