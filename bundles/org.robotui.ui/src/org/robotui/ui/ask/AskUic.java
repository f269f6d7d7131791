package org.robotui.ui.ask;

import java.util.List;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.UicContext;
import org.robotui.api.port.BrowsePort;
import org.robotui.ui.Icon;
import org.robotui.ui.SurfaceUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewItem;
import org.robotui.ui.ViewKey;
import org.robotui.ui.ask.Catalogue.Entry;

/** A view that asks. What it has asked ends with the robot interface that was asked, not with the view. */
public final class AskUic extends SurfaceUic<AskPane> {
  private final AskModel model;
  private final AskWords words;

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
    offers().add("again", "Read the form from the robot again", Icon.RESTART, model::again);
  }

  @Override
  public boolean tick(long nowNanos) {
    return model.tick(nowNanos);
  }

  @Override
  protected AskPane open(Composite parent, UiContext context) {
    return new AskPane(parent, context, model, words);
  }

  @Override
  protected void refresh(AskPane shown) {
    shown.refresh();
  }

  @Override
  public List<ViewItem> items() {
    return model.shown().listing().entries().stream().map(this::item).toList();
  }

  private ViewItem item(Entry entry) {
    return new ViewItem(words.label(), entry.item().name(), entry.item().type(),
        () -> atSurface(pane -> pane.find(entry)));
  }

  @Override
  public List<ViewKey> keys() {
    return List.of(new ViewKey("Ctrl+Enter", words.verb()), new ViewKey("Ctrl+F, /", "Filter"));
  }
}
