package org.robotui.workbench.internal.dock;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.Uic;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.Ruic;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.host.RuicState;
import org.robotui.api.show.Subject;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.SwtUic;
import org.robotui.ui.Theme;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewAction;
import org.robotui.ui.ViewItem;
import org.robotui.ui.ViewKey;
import org.robotui.workbench.internal.pane.MessagePane;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The place of one view: its control, or why there is none and a button to restart it. A view that throws here fails
 * alone. Display thread only.
 */
final class ViewHolder extends Composite implements UiContext {
  /** Is told what the title line has to show. */
  interface Title {
    void changed(ViewHolder holder);
  }

  private static final Logger LOG = LoggerFactory.getLogger(ViewHolder.class);

  private final Theme theme;
  private final Ruic ruic;
  private final String id;
  private Title title = holder -> {};
  private Optional<SwtUic> shown = Optional.empty();
  private String said = "";
  private String note = "";

  ViewHolder(Composite parent, Theme theme, Ruic ruic, String id) {
    super(parent, SWT.NONE);
    this.theme = theme;
    this.ruic = ruic;
    this.id = id;
    setBackground(theme.color(Role.PANEL));
    setLayout(new FillLayout());
    // A view may keep what it was given, and so must not keep the window that it was shown in.
    addListener(SWT.Dispose, e -> title = holder -> {});
  }

  String id() {
    return id;
  }

  String ruicName() {
    return ruic.name();
  }

  /** Whether it shows its view, and not why there is none. */
  boolean runs() {
    return shown.isPresent();
  }

  /** Puts it elsewhere: what it shows goes on. */
  void into(Composite parent, Title line) {
    title = line;
    setParent(parent);
  }

  String noteText() {
    return note;
  }

  List<ViewAction> actions() {
    return shown.map(SwtUic::actions).orElse(List.of());
  }

  List<ViewKey> keys() {
    return shown.map(SwtUic::keys).orElse(List.of());
  }

  List<ViewItem> items() {
    return shown.map(SwtUic::items).orElse(List.of());
  }

  /** How near to a failure code of the view lies; none where it took no part. */
  OptionalInt guilt(Throwable failure) {
    return shown.map(uic -> Blame.distance(uic.getClass(), failure)).orElse(OptionalInt.empty());
  }

  /** Shows the instance that runs now, or why there is none. */
  void showInstance(RuicSnapshot snapshot) {
    Optional<String> failure = failure(snapshot);
    Optional<SwtUic> now = failure.isPresent() ? Optional.empty()
        : ruic.uic(id).filter(SwtUic.class::isInstance).map(SwtUic.class::cast);
    if (now.isEmpty()) {
      explain(failure.orElseGet(() -> absence(ruic.uic(id))));
    } else if (shown.isEmpty() || shown.get() != now.get()) {
      create(now.get());
    }
  }

  /** Has the view show what its last ticks prepared. */
  void refresh() {
    withView(SwtUic::refresh);
  }

  /** Has the view show something that the user pointed at elsewhere. */
  void view(String showing, Subject subject) {
    withView(uic -> uic.show(showing, subject));
  }

  private void withView(Consumer<SwtUic> call) {
    if (shown.isPresent()) {
      try {
        call.accept(shown.get());
      } catch (RuntimeException | Error e) {
        fail(e);
      }
    }
  }

  /** Takes the view out of the window because of something that it threw. */
  void fail(Throwable cause) {
    LOG.error("view {} of {} failed on the display thread", id, ruic.name(), cause);
    String reason = "it could not be shown: " + cause;
    ruic.surfaceFailed(id, reason);
    explain(reason);
  }

  @Override
  public Theme theme() {
    return theme;
  }

  @Override
  public void note(String text) {
    if (!note.equals(text)) {
      note = text;
      title.changed(this);
    }
  }

  private Optional<String> failure(RuicSnapshot snapshot) {
    return status(snapshot).filter(s -> s.state() == RuicState.FAILED).map(ComponentStatus::reason);
  }

  private Optional<ComponentStatus> status(RuicSnapshot snapshot) {
    return snapshot.components().stream()
        .filter(c -> c.id().equals(id) && c.kind() == ComponentStatus.Kind.UIC)
        .findFirst();
  }

  private static String absence(Optional<Uic> other) {
    return other.isPresent() ? "It is not a view for a window." : "It does not run.";
  }

  private void create(SwtUic uic) {
    clear();
    try {
      uic.createControl(this, this);
      shown = Optional.of(uic);
      uic.refresh();
      layout(true);
      title.changed(this);
    } catch (RuntimeException | Error e) {
      fail(e);
    }
  }

  private void explain(String reason) {
    if (shown.isPresent() || getChildren().length == 0 || !said.equals(reason)) {
      clear();
      said = reason;
      new MessagePane(this, theme, Health.BAD, ruic.title(id) + " does not work", reason,
          List.of(new MessagePane.Choice("Restart view", () -> ruic.restart(id))));
      layout(true);
      title.changed(this);
    }
  }

  private void clear() {
    shown = Optional.empty();
    note = "";
    said = "";
    for (Control child : getChildren()) {
      child.dispose();
    }
  }
}
