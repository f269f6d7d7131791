package org.robotui.ui.ask;

import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.SashForm;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewSurface;
import org.robotui.ui.ask.AskModel.Shown;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.ask.Catalogue.Entry;

/** The surface of a view that asks: what there is at the left, form and answer at the right. Display thread only. */
public final class AskPane implements ViewSurface {
  private static final int[] SHARES = {34, 66};

  private final AskModel model;
  private final UiContext context;
  private final AskWords words;
  private final Composite root;
  private final EntryList list;
  private final AskDetail detail;

  /**
   * Makes the controls.
   *
   * @param parent the part
   * @param context what the window gives
   * @param model the state
   * @param words how the view speaks
   */
  public AskPane(Composite parent, UiContext context, AskModel model, AskWords words) {
    this.model = model;
    this.context = context;
    this.words = words;
    root = Boxes.root(parent, context.theme(), this::setFocus);
    SashForm parts = Boxes.split(root, context.theme(), SWT.HORIZONTAL);
    parts.setLayoutData(Boxes.fill());
    list = new EntryList(parts, context.theme(), words, model, this::refresh);
    detail = new AskDetail(parts, context.theme(), words, model, this::refresh);
    parts.setWeights(SHARES);
  }

  /** Chooses one, whatever the filter hides. */
  void find(Entry entry) {
    list.find(entry);
  }

  private boolean setFocus() {
    return list.setFocus();
  }

  @Override
  public Control control() {
    return root;
  }

  /** Shows what is so now. */
  public void refresh() {
    if (!root.isDisposed()) {
      Shown shown = model.shown();
      int count = shown.listing().entries().size();
      context.note(shown.listing().robots() == 0 ? "" : words.counted(count));
      list.show(shown);
      detail.show(shown);
    }
  }
}
