package org.robotui.uic.map.internal.view;

import java.util.List;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.dnd.Clipboard;
import org.eclipse.swt.dnd.TextTransfer;
import org.eclipse.swt.dnd.Transfer;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Menu;
import org.eclipse.swt.widgets.MenuItem;
import org.robotui.data.FrameId;
import org.robotui.geometry.RigidTransform;
import org.robotui.ui.Figures;
import org.robotui.ui.scene.Layer;
import org.robotui.ui.scene.Scene;
import org.robotui.uic.map.internal.Kind;
import org.robotui.uic.map.internal.MapOptions;
import org.robotui.uic.map.internal.model.MapModel;

/** The menus of a map, made when opened and disposed when closed. Display thread. */
final class MapMenu {
  private final MapCanvas map;
  private final MapModel model;
  private final Choices choices;

  MapMenu(MapCanvas map, MapModel model, Choices choices) {
    this.map = map;
    this.model = model;
    this.choices = choices;
  }

  /** What can be done at a place, and with what lies there. */
  void open(Control control, int x, int y) {
    Menu menu = popUp(control);
    hits(menu, map.hits(new Point(x, y)));
    place(menu, control, map.viewport().worldX(x), map.viewport().worldY(y));
    new MenuItem(menu, SWT.SEPARATOR);
    layers(under(menu, "Layers"));
    frames(under(menu, "Fixed frame"));
    check(menu, "Follow the robot", map.following(), on -> map.toggleFollow());
    push(menu, "Show all", map::fit);
    menu.setVisible(true);
  }

  /** What is shown. */
  void openLayers(Control control) {
    Menu menu = popUp(control);
    layers(menu);
    menu.setVisible(true);
  }

  private void hits(Menu menu, List<Scene.Hit> hits) {
    for (Scene.Hit hit : hits) {
      Layer layer = hit.layer();
      Menu sub = under(menu, hit.description().text().lines().findFirst().orElse(layer.caption()));
      MenuItem caption = push(sub, layer.caption(), () -> { });
      caption.setEnabled(false);
      push(sub, "Hide", () -> choices.show(layer.id(), false));
    }
    if (!hits.isEmpty()) {
      new MenuItem(menu, SWT.SEPARATOR);
    }
  }

  private void place(Menu menu, Control control, double x, double y) {
    push(menu, "Go here", () -> map.sendGoal(RigidTransform.planar(x, y, map.usualHeading(x, y))));
    push(menu, "The robot is here", () -> map.sendPose(RigidTransform.planar(x, y, map.presentHeading(x, y))));
    push(menu, "Centre here", () -> map.center(x, y));
    push(menu, "Measure", () -> map.toggleTool(MapActions.MEASURE));
    push(menu, "Copy coordinates", () -> copy(control, Figures.fixed(x, 3).replace('\u2212', '-') + " "
        + Figures.fixed(y, 3).replace('\u2212', '-')));
  }

  private void layers(Menu menu) {
    MapOptions options = choices.options();
    for (Kind kind : Kind.values()) {
      check(menu, kind.label(), options.shown().contains(kind), on -> choices.show(kind, on));
      List<Layer> several = model.scene().layers().stream().filter(l -> l.order() == kind.ordinal()).toList();
      if (several.size() > 1 || several.stream().anyMatch(l -> options.hidden().contains(l.id()))) {
        several.forEach(l -> check(menu, "    " + l.caption(), !options.hidden().contains(l.id()),
            on -> choices.show(l.id(), on)));
      }
    }
    new MenuItem(menu, SWT.SEPARATOR);
    check(menu, "Free space of scans", options.fan(), choices::fan);
    check(menu, "Uncertainty of odometry", options.uncertainty(), choices::uncertainty);
  }

  private void frames(Menu menu) {
    String chosen = choices.options().fixedFrame().orElse(MapOptions.AUTO);
    radio(menu, "Automatic", chosen.equals(MapOptions.AUTO), () -> choices.fixedFrame(MapOptions.AUTO));
    List<FrameId> frames = model.snapshot().frames();
    boolean several = frames.stream().map(FrameId::robot).distinct().count() > 1;
    for (FrameId frame : frames) {
      String name = several ? frame.toString() : frame.name();
      radio(menu, name, chosen.equals(name), () -> choices.fixedFrame(name));
    }
  }

  private static Menu popUp(Control control) {
    Menu menu = new Menu(control.getShell(), SWT.POP_UP);
    // Selection is told after hiding, so the menu must live until then.
    menu.addListener(SWT.Hide, e -> menu.getDisplay().asyncExec(() -> {
      if (!menu.isDisposed()) {
        menu.dispose();
      }
    }));
    return menu;
  }

  private static Menu under(Menu menu, String label) {
    MenuItem item = new MenuItem(menu, SWT.CASCADE);
    item.setText(label);
    Menu sub = new Menu(menu);
    item.setMenu(sub);
    return sub;
  }

  private MenuItem push(Menu menu, String label, Runnable run) {
    return item(menu, SWT.PUSH, label, item -> run.run());
  }

  private void check(Menu menu, String label, boolean on, Consumer<Boolean> changed) {
    item(menu, SWT.CHECK, label, item -> changed.accept(item.getSelection())).setSelection(on);
  }

  private void radio(Menu menu, String label, boolean on, Runnable chosen) {
    item(menu, SWT.RADIO, label, item -> {
      if (item.getSelection()) {
        chosen.run();
      }
    }).setSelection(on);
  }

  private MenuItem item(Menu menu, int style, String label, Consumer<MenuItem> selected) {
    MenuItem item = new MenuItem(menu, style);
    item.setText(label);
    item.addListener(SWT.Selection, e -> {
      selected.accept(item);
      map.refresh();
    });
    return item;
  }

  private static void copy(Control control, String text) {
    Clipboard clipboard = new Clipboard(control.getDisplay());
    clipboard.setContents(new Object[] {text}, new Transfer[] {TextTransfer.getInstance()});
    clipboard.dispose();
  }
}
