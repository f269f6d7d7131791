package org.robotui.uic.camera.internal;

import java.util.Optional;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.StackLayout;
import org.eclipse.swt.dnd.Clipboard;
import org.eclipse.swt.dnd.ImageTransfer;
import org.eclipse.swt.dnd.Transfer;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.FileDialog;
import org.robotui.api.config.SettingsStore;
import org.robotui.api.port.SourceId;
import org.robotui.entity.image.Picture;
import org.robotui.ui.Face;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.ui.UiContext;
import org.robotui.ui.control.CandidateChooser;

/** What is seen of the view while it is shown. Display thread. */
final class CameraSurface {
  private static final int PILL = 22;
  private static final double PIXELS_SHOWN_FROM = 6;

  private final UiContext context;
  private final SettingsStore settings;
  private final StateView states;
  private final Composite root;
  private final StackLayout stack = new StackLayout();
  private final PaintedCanvas canvas;
  private final CandidateChooser chooser;
  private final Screen screen = new Screen();
  private final Navigation navigation;
  private Shot shot = Shot.NOTHING;

  CameraSurface(Composite parent, UiContext context, SettingsStore settings, Consumer<SourceId> chosen) {
    this.context = context;
    this.settings = settings;
    this.states = new StateView(context.theme());
    this.root = new Composite(parent, SWT.NONE);
    root.setLayout(stack);
    this.canvas = new PaintedCanvas(root, context.theme(), this::paint);
    this.chooser = new CandidateChooser(root, context.theme(), chosen);
    this.navigation = new Navigation(canvas, () -> shot.seen());
    stack.topControl = canvas;
    navigation.listen();
    canvas.atEnd(screen::dispose);
  }

  Control control() {
    return root;
  }

  void show(Shot next) {
    if (canvas.isDisposed()) {
      return;
    }
    shot = next;
    context.note(next.note());
    chooser.ask(next.state().explanation(), next.candidates());
    Control top = next.candidates().isEmpty() ? canvas : chooser;
    if (stack.topControl != top) {
      stack.topControl = top;
      root.layout();
    }
    canvas.redraw();
  }

  void fit() {
    navigation.fit();
  }

  void copy() {
    shot.picture().ifPresent(picture -> {
      Clipboard clipboard = new Clipboard(canvas.getDisplay());
      clipboard.setContents(new Object[] {picture.pixels()}, new Transfer[] {ImageTransfer.getInstance()});
      clipboard.dispose();
    });
  }

  void save(Saver saver) {
    shot.picture().ifPresent(picture -> {
      FileDialog dialog = new FileDialog(canvas.getShell(), SWT.SAVE);
      dialog.setFileName("picture.png");
      dialog.setFilterExtensions(new String[] {"*.png"});
      dialog.setOverwrite(true);
      Optional.ofNullable(dialog.open()).ifPresent(file -> saver.save(picture, file));
    });
  }

  private void paint(GC gc, Rectangle area) {
    shot.seen().ifPresent(picture -> {
      paint(gc, area, picture);
      navigation.pointer().flatMap(at -> under(at, area, picture)).ifPresent(text -> label(gc, area, text));
    });
    states.paint(gc, area, shot.state());
    shot.message().ifPresent(text -> label(gc, area, text));
  }

  private void paint(GC gc, Rectangle area, Picture picture) {
    PictureView.Placement at = navigation.view().in(area, picture.width(), picture.height());
    boolean smooth = settings.current().flag(CameraType.SMOOTH) && at.scale() < PIXELS_SHOWN_FROM;
    gc.setInterpolation(smooth ? SWT.HIGH : SWT.NONE);
    gc.setAlpha(StateView.contentAlpha(shot.state()));
    Rectangle target = at.bounds(picture.width(), picture.height());
    gc.drawImage(screen.image(canvas.getDisplay(), picture), 0, 0, picture.width(), picture.height(),
        target.x, target.y, target.width, target.height);
    gc.setAlpha(255);
  }

  private Optional<String> under(Point pointer, Rectangle area, Picture picture) {
    Point pixel = navigation.view().in(area, picture.width(), picture.height()).pixel(pointer.x, pointer.y);
    if (!new Rectangle(0, 0, picture.width(), picture.height()).contains(pixel)) {
      return Optional.empty();
    }
    String bearing = shot.info()
        .flatMap(info -> Bearing.of(info, pixel.x, pixel.y, picture.width(), picture.height()))
        .map(b -> "   " + b.text()).orElse("");
    return Optional.of(String.format("x %4d  y %4d   %s%s", pixel.x, pixel.y, picture.values().at(pixel.x, pixel.y), bearing));
  }

  private void label(GC gc, Rectangle area, String words) {
    gc.setFont(context.theme().font(Face.SMALL_FIGURES));
    String text = TextFit.shorten(gc, words, area.width - 4 * Theme.EDGE);
    Point size = gc.textExtent(text);
    Rectangle pill = new Rectangle(area.x + Theme.EDGE, area.y + area.height - Theme.EDGE - PILL, size.x + 4 * Theme.STEP, PILL);
    states.pill(gc, pill);
    gc.setForeground(context.theme().color(Role.TEXT));
    gc.drawText(text, pill.x + 2 * Theme.STEP, pill.y + (PILL - size.y) / 2, true);
  }
}
