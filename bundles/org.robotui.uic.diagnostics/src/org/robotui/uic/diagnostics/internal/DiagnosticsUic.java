package org.robotui.uic.diagnostics.internal;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.UicContext;
import org.robotui.api.port.Input;
import org.robotui.data.status.Diagnostics;
import org.robotui.ui.SwtUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewAction;
import org.robotui.ui.ViewKey;
import org.robotui.uic.diagnostics.internal.model.Ask;
import org.robotui.uic.diagnostics.internal.model.DiagnosticsModel;
import org.robotui.uic.diagnostics.internal.view.DiagnosticsHands;
import org.robotui.uic.diagnostics.internal.view.DiagnosticsSurface;
import org.robotui.uic.diagnostics.internal.view.Frame;

/** The view: the tick takes and remembers, the surface shows the tree. */
final class DiagnosticsUic implements SwtUic {
  private final UicContext context;
  private final Input<Diagnostics> input;
  private final DiagnosticsModel model;
  private final Hands hands = new Hands();
  private final List<ViewAction> actions;
  private volatile Frame frame;
  private Optional<DiagnosticsSurface> surface = Optional.empty();

  DiagnosticsUic(UicContext context) {
    this.context = context;
    this.input = context.input(DiagnosticsType.DIAGNOSTICS);
    this.model = new DiagnosticsModel(input, context.settings().current().integer(DiagnosticsType.HISTORY));
    model.ask(DiagnosticsPreferences.read(context.settings().current()));
    this.frame = frame();
    this.actions = List.of(new ViewAction("forget", "Forget parts that do not report any more", "minus",
        Optional.empty(), hands::forgetSilent));
  }

  @Override
  public boolean tick(long now) {
    boolean news = model.tick(now, context.settings().current().number(DiagnosticsType.STALE_AFTER));
    Frame next = frame();
    boolean changed = news || next.state().getClass() != frame.state().getClass();
    frame = next;
    return changed;
  }

  @Override
  public Control createControl(Composite parent, UiContext ui) {
    DiagnosticsSurface made = new DiagnosticsSurface(parent, ui, hands);
    surface = Optional.of(made);
    made.show(frame);
    return made.control();
  }

  @Override
  public List<ViewKey> keys() {
    return List.of(
        new ViewKey("Enter, arrows", "Expand or collapse a group"),
        new ViewKey("Ctrl+F, /", "Search"),
        new ViewKey("Left, right", "Step through the history, on its strip"),
        new ViewKey("Esc", "Return to now, close the details"));
  }

  @Override
  public void refresh() {
    surface.ifPresent(s -> s.show(frame));
  }

  @Override
  public List<ViewAction> actions() {
    return actions;
  }

  @Override
  public void close() {
    // Nothing is held but memory.
  }

  private Frame frame() {
    return new Frame(model.current(), model.ask(), input.state());
  }

  /** What the user can do. Display thread. */
  private final class Hands implements DiagnosticsHands {
    @Override
    public void ask(Ask next) {
      model.ask(next);
      DiagnosticsPreferences.write(context.settings(), next);
      frame = frame();
      refresh();
    }

    @Override
    public void forgetSilent() {
      model.forgetSilent();
    }
  }
}
