package org.robotui.uic.map.internal.view;

import java.util.List;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.widgets.Control;
import org.robotui.data.FrameId;
import org.robotui.geometry.RigidTransform;
import org.robotui.ui.Figures;
import org.robotui.ui.control.Clipboards;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.scene.Layer;
import org.robotui.ui.scene.Scene;
import org.robotui.uic.map.internal.MapOptions;
import org.robotui.uic.map.internal.model.MapModel;

/** The menus of a map, made when opened and disposed when closed. Display thread. */
final class MapMenu {
  private final MapCanvas map;
  private final MapModel model;
  private final MapChoices choices;

  MapMenu(MapCanvas map, MapModel model, MapChoices choices) {
    this.map = map;
    this.model = model;
    this.choices = choices;
  }

  /** What can be done at a place, and with what lies there. */
  void open(Control control, int x, int y) {
    PopupMenu menu = new PopupMenu(control, map::refresh);
    hits(menu, map.hits(new Point(x, y)));
    place(menu, map.mover().viewport().worldX(x), map.mover().viewport().worldY(y));
    menu.line();
    menu.check("Layers", map.listOpen(), on -> map.toggleList());
    frames(menu.under("Fixed frame"));
    menu.check("Follow the robot", map.following(), on -> map.toggleFollow());
    menu.push("Show all", () -> map.mover().fit());
    menu.open();
  }

  /** Asks whether really all shall go. */
  void askAll(Control control, FrameId fixed, RigidTransform pose) {
    new PopupMenu(control, map::refresh)
        .push("Send all selected robots there: that is every one", false, () -> {})
        .push("Yes, send all", () -> map.team().sendMeant(fixed, pose))
        .push("No", () -> {})
        .open();
  }

  private void hits(PopupMenu menu, List<Scene.Hit> hits) {
    for (Scene.Hit hit : hits) {
      Layer layer = hit.layer();
      menu.under(hit.description().text().lines().findFirst().orElse(layer.caption()))
          .push(layer.caption(), false, () -> {})
          .push("Hide", () -> model.layers().list().change(layer.id(), spec -> spec.show(false)));
    }
    menu.line();
  }

  private void place(PopupMenu menu, double x, double y) {
    RigidTransform there = RigidTransform.planar(x, y, map.usualHeading(x, y));
    if (map.team().isTeam()) {
      model.snapshot().fixed().ifPresent(fixed -> map.team().menu(menu, fixed, RigidTransform.planar(x, y, 0)));
    } else {
      menu.push("Send a goal here", () -> map.sendGoal(there));
    }
    menu.push(map.team().isTeam() ? "Set the pose estimate of the selected robot here" : "Set the pose estimate here",
        () -> map.sendPose(RigidTransform.planar(x, y, map.presentHeading(x, y))));
    menu.push("Centre here", () -> map.mover().center(x, y));
    menu.push("Measure", () -> map.toggleTool(MapActions.MEASURE));
    menu.push("Copy coordinates", () -> Clipboards.copy(Figures.fixed(x, 3).replace('\u2212', '-') + " "
        + Figures.fixed(y, 3).replace('\u2212', '-')));
  }

  private void frames(PopupMenu menu) {
    String chosen = choices.options().fixedFrame().orElse(MapOptions.AUTO);
    menu.radio("Automatic", chosen.equals(MapOptions.AUTO), () -> choices.fixedFrame(MapOptions.AUTO));
    List<FrameId> frames = model.snapshot().frames();
    boolean several = frames.stream().map(FrameId::robot).distinct().count() > 1;
    for (FrameId frame : frames) {
      String name = several ? frame.toString() : frame.name();
      menu.radio(name, chosen.equals(name), () -> choices.fixedFrame(name));
    }
  }
}
