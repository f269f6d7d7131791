package org.robotui.workbench.internal.dock;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.StackLayout;
import org.eclipse.swt.graphics.Point;
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
  /** Is told what the user does with the titles. */
  interface Gestures {
    /** Another view is in front. */
    void fronted(String view);

    /** The menu of a view is wanted. */
    void menu(ViewStack stack, String view, Point at);

    /** A view is to have the whole window, or its place again. */
    void maximize(ViewStack stack);

    /** A view is to be closed. */
    void close(String view);

    /** A view is dragged. */
    void drag(String view, Point at);

    /** It is let go. */
    void drop(Point at);
  }

  private final TitleLine line;
  private final Composite body;
  private final StackLayout stack = new StackLayout();
  private final List<ViewHolder> holders;
  private final Ruic ruic;

  ViewStack(Composite parent, Theme theme, Ruic ruic, List<String> ids, int front, Holders all, Gestures gestures) {
    super(parent, SWT.NONE);
    this.ruic = ruic;
    setBackground(theme.color(Role.PANEL));
    GridLayout layout = new GridLayout(1, false);
    layout.marginWidth = 0;
    layout.marginHeight = 0;
    layout.verticalSpacing = 0;
    setLayout(layout);
    line = new TitleLine(this, theme, ids.stream().map(ruic::title).toList(), new Titles(ids, gestures));
    line.setLayoutData(new GridData(SWT.FILL, SWT.TOP, true, false));
    body = new Body(this);
    body.setBackground(getBackground());
    body.setLayoutData(new GridData(SWT.FILL, SWT.FILL, true, true));
    body.setLayout(stack);
    holders = ids.stream().map(id -> all.into(id, body, this::titleChanged)).toList();
    choose(front);
  }

  /** Keeps the places of views while stacks come and go. */
  interface Holders {
    /** The place of a view, put into a stack. */
    ViewHolder into(String id, Composite body, ViewHolder.Title title);
  }

  /** Holds the views; not a plain composite, which style sheets would colour. */
  private static final class Body extends Composite {
    Body(Composite parent) {
      super(parent, SWT.NONE);
    }
  }

  /** What is done with a title is done with its view. */
  private final class Titles implements TitleLine.Gestures {
    private final List<String> ids;
    private final Gestures gestures;

    Titles(List<String> ids, Gestures gestures) {
      this.ids = ids;
      this.gestures = gestures;
    }

    @Override
    public void choose(int index) {
      ViewStack.this.choose(index);
      gestures.fronted(ids.get(index));
    }

    @Override
    public void menu(int index, Point at) {
      gestures.menu(ViewStack.this, ids.get(index), at);
    }

    @Override
    public void maximize() {
      gestures.maximize(ViewStack.this);
    }

    @Override
    public void close(int index) {
      gestures.close(ids.get(index));
    }

    @Override
    public void drag(int index, Point at) {
      gestures.drag(ids.get(index), at);
    }

    @Override
    public void drop(Point at) {
      gestures.drop(at);
    }
  }

  Stream<ViewHolder> holders() {
    return holders.stream();
  }

  List<String> ids() {
    return holders.stream().map(ViewHolder::id).toList();
  }

  TitleLine line() {
    return line;
  }

  void choose(int index) {
    ViewHolder holder = holders.get(index);
    boolean other = stack.topControl != holder;
    stack.topControl = holder;
    line.show(index);
    if (other) {
      holder.showInstance(ruic.snapshot());
    }
    titleChanged(holder);
    body.layout(true);
  }

  void maximized(boolean now) {
    line.maximized(now);
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

  /** Has a view show something, where it is the one that is seen. */
  void view(String id, String showing, Subject subject) {
    if (seenId().equals(id)) {
      seen().view(showing, subject);
    }
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

  /** The view that is in front, where it runs. */
  Optional<SeenView> seenView() {
    return Stream.of(seen().getChildren()).findFirst().flatMap(SeenView::of);
  }

  /** Shows a view, if it is one of these, and gives it the keys. */
  boolean reveal(String id) {
    int index = ids().indexOf(id);
    if (index >= 0) {
      choose(index);
      setFocus();
    }
    return index >= 0;
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
