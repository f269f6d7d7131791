package org.robotui.uic.diagnostics.internal;

import java.util.List;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.UicContext;
import org.robotui.api.port.Input;
import org.robotui.data.status.Diagnostics;
import org.robotui.ui.Icon;
import org.robotui.ui.SurfaceUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewKey;
import org.robotui.uic.diagnostics.internal.model.Ask;
import org.robotui.uic.diagnostics.internal.model.DiagnosticsModel;
import org.robotui.uic.diagnostics.internal.view.DiagnosticsHands;
import org.robotui.uic.diagnostics.internal.view.DiagnosticsSurface;
import org.robotui.uic.diagnostics.internal.view.Frame;

/** The view: the tick takes and remembers, the surface shows the tree. */
final class DiagnosticsUic extends SurfaceUic<DiagnosticsSurface> {
  private final UicContext context;
  private final Input<Diagnostics> input;
  private final DiagnosticsModel model;
  private final Hands hands = new Hands();
  private volatile Frame frame;

  DiagnosticsUic(UicContext context) {
    this.context = context;
    this.input = context.input(DiagnosticsType.DIAGNOSTICS);
    this.model = new DiagnosticsModel(input, context.settings().current().integer(DiagnosticsType.HISTORY),
        context.clock()::agingNanos);
    model.ask(DiagnosticsPreferences.read(context.settings().current()));
    this.frame = frame();
    offers().add("forget", "Forget parts that do not report any more", Icon.MINUS, hands::forgetSilent);
  }

  @Override
  public boolean tick(long nowNanos) {
    boolean news = model.tick(nowNanos, context.settings().current().number(DiagnosticsType.STALE_AFTER));
    Frame next = frame();
    boolean changed = news || next.state().getClass() != frame.state().getClass();
    frame = next;
    return changed;
  }

  @Override
  protected DiagnosticsSurface open(Composite parent, UiContext ui) {
    return new DiagnosticsSurface(parent, ui, hands);
  }

  @Override
  protected void refresh(DiagnosticsSurface shown) {
    shown.show(frame);
  }

  @Override
  public List<ViewKey> keys() {
    return List.of(
        new ViewKey("Enter, arrows", "Expand or collapse a group"),
        new ViewKey("Ctrl+F, /", "Search"),
        new ViewKey("Left, right", "Step through the history, on its strip"),
        new ViewKey("Esc", "Return to now, close the details"));
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
