package org.robotui.uic.teleop.internal;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.Stream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.config.SettingsStore;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewSurface;
import org.robotui.ui.control.LimitBar;
import org.robotui.uic.teleop.internal.TeleopFooter.Button;

/** What is seen of the view while it is shown. Display thread. */
final class TeleopSurface implements ViewSurface {
  private static final double ROUNDING = 100;

  private final UiContext context;
  private final Driver driver;
  private final TeleopPainter painter;
  private final Composite root;
  private final PaintedCanvas canvas;
  private final LimitBar linear;
  private final LimitBar angular;
  private final FooterButtons buttons;
  private TeleopViewState look;

  TeleopSurface(Composite parent, UiContext context, Driver driver, SettingsStore settings) {
    this.context = context;
    this.driver = driver;
    this.look = driver.look(System.nanoTime());
    this.painter = new TeleopPainter(context.theme());
    this.root = new Root(parent);
    this.canvas = new PaintedCanvas(root, context.theme(), this::paint);
    this.linear = bar(TeleopType.HIGHEST_LINEAR, TeleopType.MAX_LINEAR, settings, "Speed at full stick");
    this.angular = bar(TeleopType.HIGHEST_ANGULAR, TeleopType.MAX_ANGULAR, settings, "Turning speed at full stick");
    this.buttons = new FooterButtons(root, context.theme(), this::pressed);
    new TeleopInput(canvas, driver, this::drivable, this::refresh).listen();
    root.addListener(SWT.Resize, e -> place());
    canvas.addListener(SWT.MouseMove, e -> tell(e.y));
    // The stick lies below the bars and buttons, and comes first when walking through by key.
    canvas.moveBelow(null);
    root.setTabList(tabs());
    root.addDisposeListener(e -> leave());
    new SeenWatch(root, () -> driver.seen(System.nanoTime())).begin();
  }

  @Override
  public Control control() {
    return root;
  }

  void refresh() {
    if (canvas.isDisposed()) {
      return;
    }
    look = driver.look(System.nanoTime());
    linear.value(look.limits().linear());
    angular.value(look.limits().angular());
    linear.mark(look.held() ? Math.abs(look.commanded().forward()) : Double.NaN);
    angular.mark(look.held() ? Math.abs(look.commanded().turn()) : Double.NaN);
    context.note(look.note());
    place();
    canvas.redraw();
  }

  /** Gives the focus to the stick, not to the first bar upon it, so that keys drive. */
  private final class Root extends Composite {
    Root(Composite parent) {
      super(parent, SWT.NONE);
      setBackground(context.theme().color(Role.PANEL));
    }

    @Override
    public boolean setFocus() {
      return canvas.forceFocus();
    }
  }

  /** The focus goes while all still stands: GTK would tell a half disposed canvas that it has lost it. */
  private void leave() {
    driver.leave();
    canvas.setEnabled(false);
  }

  private Optional<Rectangle> drivable() {
    return StateView.showsContent(look.output()) ? Optional.of(layout().stick()) : Optional.empty();
  }

  private TeleopLayout layout() {
    Rectangle area = root.getClientArea();
    return TeleopLayout.of(area.width, area.height);
  }

  private LimitBar bar(double highest, String setting, SettingsStore settings, String hint) {
    LimitBar bar = new LimitBar(root, context.theme(), highest, value -> {
      settings.set(setting, Math.round(value * ROUNDING) / ROUNDING);
      refresh();
    });
    bar.setToolTipText(hint + ": drag, wheel or arrow keys");
    return bar;
  }

  /** The whole sentence of the footer, which may have been shortened, over the footer alone. */
  private void tell(int y) {
    String text = y >= layout().footer().y ? TeleopFooter.of(look).text().replace("&", "&&") : "";
    if (!text.equals(canvas.getToolTipText())) {
      canvas.setToolTipText(text);
    }
  }

  private Control[] tabs() {
    return Stream.concat(Stream.of(canvas), Arrays.stream(root.getChildren()).filter(c -> c != canvas))
        .toArray(Control[]::new);
  }

  private void place() {
    canvas.setBounds(root.getClientArea());
    TeleopLayout at = layout();
    boolean bars = at.bars() > 0 && StateView.showsContent(look.output());
    place(linear, at.bar(0), bars);
    place(angular, at.bar(1), bars);
    buttons.show(TeleopFooter.of(look).buttons(), look.robot(), at.footer());
  }

  private static void place(LimitBar bar, Rectangle at, boolean seen) {
    bar.setBounds(at.x, at.y, at.width, TeleopPainter.BAR_HEIGHT);
    bar.setVisible(seen);
  }

  private void paint(GC gc, Rectangle area) {
    TeleopLayout at = TeleopLayout.of(area.width, area.height);
    painter.paint(gc, at, look, canvas.isFocusControl());
    painter.footer(gc, at.footer(), TeleopFooter.of(look), buttons.left());
  }

  private void pressed(Button button) {
    switch (button) {
      case TAKE -> driver.take();
      case RELEASE_CONTROL -> driver.giveBack();
      case ASK -> driver.ask(true);
      case CANCEL -> driver.ask(false);
      case TAKE_OVER -> driver.takeOver();
      case RELEASE_STOP -> driver.releaseStop();
    }
    canvas.forceFocus();
    refresh();
  }
}
