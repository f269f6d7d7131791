package org.robotui.ui.ask;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.UicContext;
import org.robotui.api.port.BrowsePort;
import org.robotui.ui.SwtUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewAction;
import org.robotui.ui.ViewKey;

/** A view that asks. What it has asked ends with the robot interface that was asked, not with the view. */
public final class AskUic implements SwtUic {
  private final AskModel model;
  private final AskWords words;
  private final List<ViewAction> actions;
  private Optional<AskPane> pane = Optional.empty();

  /**
   * Makes a view.
   *
   * @param context what core gives
   * @param graph where to list what can be asked
   * @param words how the view speaks
   * @param asker asks
   */
  public AskUic(UicContext context, BrowsePort graph, AskWords words, Asker asker) {
    this.words = words;
    this.model =
        new AskModel(new Catalogue(context.browse(graph), context.background(), words.kind()), new Questions(asker));
    this.actions = List.of(
        new ViewAction("again", "Read the form from the robot again", "restart", Optional.empty(), model::again));
  }

  @Override
  public boolean tick(long nowNanos) {
    return model.tick(nowNanos);
  }

  @Override
  public Control createControl(Composite parent, UiContext context) {
    AskPane made = new AskPane(parent, context, model, words);
    pane = Optional.of(made);
    return made.control();
  }

  @Override
  public void refresh() {
    pane.ifPresent(AskPane::refresh);
  }

  @Override
  public List<ViewKey> keys() {
    return List.of(new ViewKey("Ctrl+Enter", words.verb()), new ViewKey("Ctrl+F, /", "Filter"));
  }

  @Override
  public List<ViewAction> actions() {
    return actions;
  }

  @Override
  public void close() {
    // nothing is held but memory
  }
}
