package org.robotui.workbench.internal.pane;

import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.StackLayout;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.host.Ruic;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.show.Subject;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/**
 * Views of which one is seen, below their title line. A view gets its control when it is seen for the first time.
 * Display thread only.
 */
final class ViewStack extends Composite {
  private final TitleLine line;
  private final Composite body;
  private final StackLayout stack = new StackLayout();
  private final List<ViewHolder> holders;
  private final Ruic ruic;

  ViewStack(Composite parent, Theme theme, Ruic ruic, List<String> ids) {
    super(parent, SWT.NONE);
    this.ruic = ruic;
    setBackground(theme.color(Role.PANEL));
    GridLayout layout = new GridLayout(1, false);
    layout.marginWidth = 0;
    layout.marginHeight = 0;
    layout.verticalSpacing = 0;
    setLayout(layout);
    line = new TitleLine(this, theme, ids.stream().map(ruic::title).toList(), this::choose);
    line.setLayoutData(new GridData(SWT.FILL, SWT.TOP, true, false));
    body = new Body(this);
    body.setBackground(getBackground());
    body.setLayoutData(new GridData(SWT.FILL, SWT.FILL, true, true));
    body.setLayout(stack);
    holders = ids.stream().map(id -> new ViewHolder(body, theme, ruic, id, this::titleChanged)).toList();
    choose(0);
  }

  /** Holds the views; not a plain composite, which style sheets would colour. */
  private static final class Body extends Composite {
    Body(Composite parent) {
      super(parent, SWT.NONE);
    }
  }

  Stream<ViewHolder> holders() {
    return holders.stream();
  }

  TitleLine line() {
    return line;
  }

  void choose(int index) {
    ViewHolder holder = holders.get(index);
    stack.topControl = holder;
    line.show(index);
    holder.showInstance(ruic.snapshot());
    titleChanged(holder);
    body.layout(true);
  }

  /** Shows the instance that runs now; views not yet seen wait. */
  void showInstances(RuicSnapshot now) {
    seen().showInstance(now);
    holders.stream().filter(h -> h != seen() && h.getChildren().length > 0).forEach(h -> h.showInstance(now));
  }

  void refresh(String id) {
    holders.stream().filter(h -> h.id().equals(id) && h == seen()).forEach(ViewHolder::refresh);
    line.checks();
  }

  /** Brings a view to the front, where it is among these, and has it show something. */
  void view(String id, String showing, Subject subject) {
    IntStream.range(0, holders.size()).filter(i -> holders.get(i).id().equals(id)).findFirst().ifPresent(index -> {
      choose(index);
      setFocus();
      holders.get(index).view(showing, subject);
    });
  }

  @Override
  public boolean setFocus() {
    return !seen().isDisposed() && seen().setFocus();
  }

  boolean isSeen(ViewHolder holder) {
    return holder == seen();
  }

  String seenId() {
    return seen().id();
  }

  /** Shows a view, if it is one of these, and gives it the keys. */
  void reveal(String id) {
    for (int i = 0; i < holders.size(); i++) {
      if (holders.get(i).id().equals(id)) {
        choose(i);
        setFocus();
      }
    }
  }

  /** Whether what is typed goes to the view that is seen. */
  boolean holdsFocus() {
    for (Control at = getDisplay().getFocusControl(); at != null; at = at.getParent()) {
      if (at == this) {
        return true;
      }
    }
    return false;
  }

  void markFocus() {
    line.focused(holdsFocus());
  }

  private ViewHolder seen() {
    return (ViewHolder) stack.topControl;
  }

  /** Views still speak while their window closes, when the line above them is gone already. */
  private void titleChanged(ViewHolder holder) {
    if (holder == stack.topControl && !line.isDisposed()) {
      line.note(holder.noteText());
      line.actions(holder.actions());
    }
  }
}
