package org.robotui.uic.status.internal;

import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Text;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.UiContext;
import org.robotui.ui.control.QuietButton;

/** What is seen of the view while it is shown: a line of controls, and the list. Display thread. */
final class StatusSurface {
  private static final int WIDEST_FILTER = 180;

  private final UiContext context;
  private final Composite root;
  private final QuietButton ports;
  private final QuietButton connections;
  private final Text filter;
  private final QuietButton stop;
  private final QuietButton release;
  private final RowList list;

  StatusSurface(Composite parent, UiContext context, StatusUic.Actions actions) {
    this.context = context;
    this.root = new Composite(parent, SWT.NONE);
    root.setBackground(context.theme().color(Role.PANEL));
    root.setLayout(layout(1));
    Composite bar = bar();
    this.ports = new QuietButton(bar, context.theme(), () -> actions.connections(false)).text("Ports");
    this.connections = new QuietButton(bar, context.theme(), () -> actions.connections(true)).text("Connections");
    this.filter = filter(bar);
    this.stop = button(bar, actions::stop, "Stop").hint("Stops the robot until the stop is released");
    this.release = button(bar, actions::releaseStop, "Release stop").fill(Role.ACCENT);
    sameWidth(stop, release);
    this.list = new RowList(root, context.theme());
    list.control().setLayoutData(new GridData(SWT.FILL, SWT.FILL, true, true));
    filter.addListener(SWT.Modify, e -> list.filter(filter.getText()));
    filter.addListener(SWT.KeyDown, e -> leave(e.keyCode));
    list.onFind(filter::setFocus);
  }

  Control control() {
    return root;
  }

  void show(Look look) {
    if (root.isDisposed()) {
      return;
    }
    context.note(look.note());
    ports.checked(!look.connections());
    connections.checked(look.connections());
    boolean stopped = look.stoppedBy().isPresent();
    release.hint(look.stoppedBy().map(by -> "Stopped by " + by).orElse("Stopped"));
    if (seen(stop, !stopped) | seen(release, stopped)) {
      root.layout(true, true);
    }
    list.show(look);
  }

  /** The one that replaces the other takes the same room, so that nothing moves. */
  private static void sameWidth(QuietButton one, QuietButton other) {
    int width = Math.max(one.computeSize(SWT.DEFAULT, SWT.DEFAULT).x, other.computeSize(SWT.DEFAULT, SWT.DEFAULT).x);
    ((GridData) one.getLayoutData()).widthHint = width;
    ((GridData) other.getLayoutData()).widthHint = width;
  }

  private static boolean seen(QuietButton button, boolean wanted) {
    GridData data = (GridData) button.getLayoutData();
    boolean changed = data.exclude == wanted;
    data.exclude = !wanted;
    button.setVisible(wanted);
    return changed;
  }

  private void leave(int keyCode) {
    switch (keyCode) {
      case SWT.ESC -> filter.setText("");
      case SWT.ARROW_DOWN -> list.control().setFocus();
      default -> { }
    }
  }

  private Composite bar() {
    Composite bar = new Composite(root, SWT.NONE);
    bar.setBackground(root.getBackground());
    bar.setLayoutData(new GridData(SWT.FILL, SWT.TOP, true, false));
    GridLayout layout = layout(5);
    layout.marginWidth = 2 * Theme.STEP;
    layout.marginHeight = Theme.STEP;
    layout.horizontalSpacing = Theme.STEP;
    bar.setLayout(layout);
    return bar;
  }

  private static GridLayout layout(int columns) {
    GridLayout layout = new GridLayout(columns, false);
    layout.marginWidth = 0;
    layout.marginHeight = 0;
    layout.verticalSpacing = 0;
    return layout;
  }

  private Text filter(Composite bar) {
    Text text = new Text(bar, SWT.SINGLE);
    text.setMessage("Filter");
    text.setToolTipText("Shows only what contains these words; Esc clears");
    text.setFont(context.theme().font(Face.BODY));
    text.setBackground(context.theme().color(Role.GROUND));
    text.setForeground(context.theme().color(Role.TEXT));
    GridData data = new GridData(SWT.END, SWT.CENTER, true, false);
    data.widthHint = WIDEST_FILTER;
    data.minimumWidth = 0;
    text.setLayoutData(data);
    return text;
  }

  private QuietButton button(Composite bar, Runnable action, String text) {
    QuietButton button = new QuietButton(bar, context.theme(), action).text(text);
    button.setLayoutData(new GridData(SWT.END, SWT.CENTER, false, false));
    return button;
  }
}
