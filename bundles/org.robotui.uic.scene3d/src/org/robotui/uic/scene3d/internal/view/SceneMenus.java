package org.robotui.uic.scene3d.internal.view;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.widgets.Control;
import org.robotui.data.FrameId;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.render.Pick;
import org.robotui.gl.shape.Handle;
import org.robotui.ui.Figures;
import org.robotui.ui.control.Clipboards;
import org.robotui.ui.control.NameDialog;
import org.robotui.ui.control.PopupMenu;
import org.robotui.uic.scene3d.internal.SceneOptions;
import org.robotui.uic.scene3d.internal.SceneParts;
import org.robotui.uic.scene3d.internal.camera.CameraKind;
import org.robotui.uic.scene3d.internal.model.Edits;
import org.robotui.uic.scene3d.internal.model.Picks;
import org.robotui.uic.scene3d.internal.model.Selection;
import org.robotui.uic.scene3d.internal.waypoint.Route;
import org.robotui.uic.scene3d.internal.waypoint.Waypoints;

/** The menus of a scene, made when opened and disposed when closed. Display thread. */
final class SceneMenus {
  private static final int MOST_FRAMES = 60;

  private final SceneSurface scene;
  private final SceneParts parts;

  SceneMenus(SceneSurface scene, SceneParts parts) {
    this.scene = scene;
    this.parts = parts;
  }

  /** What can be done at a place, and with what lies there. */
  void context(Control control, Optional<Pick> hit, Optional<Vector3> place) {
    PopupMenu menu = new PopupMenu(control, scene::refresh);
    hit.ifPresent(h -> {
      h.part().handle().ifPresent(handle -> choices(menu, handle, handle.menu()));
      menu.line();
      thing(menu, h);
    });
    place.ifPresent(p -> place(menu, p));
    menu.line();
    waypoints(menu.under("Waypoints"));
    fixed(menu.under("Fixed frame"));
    cameras(menu.under("Camera"));
    menu.push("Show all", scene::fit);
    menu.check("Displays", scene.treeOpen(), on -> scene.toggleTree());
    menu.open();
  }

  /** How the camera is moved, and views that are kept. */
  void camera(Control control) {
    PopupMenu menu = new PopupMenu(control, scene::refresh);
    cameras(menu);
    menu.line();
    fixed(menu.under("Fixed frame"));
    menu.open();
  }

  /** What the camera keeps up with. */
  void follow(Control control) {
    PopupMenu menu = new PopupMenu(control, scene::refresh);
    follows(menu);
    menu.open();
  }

  /** Sizes of pictures. */
  void screenshot(Control control) {
    PopupMenu menu = new PopupMenu(control, scene::refresh);
    Screenshot shot = new Screenshot(scene, parts);
    double scale = scene.surface().scale();
    Point size = control.getSize();
    size(menu, shot, (int) (size.x * scale), (int) (size.y * scale), "As seen");
    size(menu, shot, 1920, 1080, "Full HD");
    size(menu, shot, 3840, 2160, "4K");
    menu.push("Other size\u2026",
        () -> SizeDialog.ask(scene.canvas(), size.x, size.y).ifPresent(s -> shot.save(s.x, s.y)));
    menu.open();
  }

  private static void size(PopupMenu menu, Screenshot shot, int width, int height, String name) {
    menu.push(name + "  (" + width + " \u00d7 " + height + ")\u2026", () -> shot.save(width, height));
  }

  private void choices(PopupMenu menu, Handle handle, List<Handle.Choice> choices) {
    for (Handle.Choice choice : choices) {
      if (!choice.children().isEmpty()) {
        choices(menu.under(choice.label()), handle, choice.children());
      } else if (choice.checked()) {
        menu.check(choice.label(), true, on -> choose(handle, choice));
      } else {
        menu.push(choice.label(), () -> choose(handle, choice));
      }
    }
  }

  private void choose(Handle handle, Handle.Choice choice) {
    parts.model().soon(() -> handle.choose(choice.id()));
  }

  private void thing(PopupMenu menu, Pick hit) {
    Selection selection = Picks.of(hit);
    PopupMenu under = menu.under(selection.properties().title());
    under.push("Select", () -> parts.picks().select(Optional.of(selection)));
    under.push("Focus", () -> {
      parts.picks().select(Optional.of(selection));
      scene.focusSelection();
    });
    if (parts.model().stage().rows().stream().anyMatch(row -> row.spec().id().equals(selection.display()))) {
      under.push("Hide its display", () -> parts.edits().change(selection.display(), s -> s.show(false)));
    }
    under.line();
    selection.properties().entries()
        .forEach(e -> under.push(e.name() + ":  " + e.value(), () -> Clipboards.copy(e.value())));
  }

  private void place(PopupMenu menu, Vector3 place) {
    double heading = scene.tools().heading(place);
    RigidTransform pose = RigidTransform.planar(place.x(), place.y(), heading);
    menu.line();
    menu.push("Send a goal here", () -> scene.tools().send(ToolKind.GOAL, pose));
    menu.push("Set the pose estimate here", () -> scene.tools().send(ToolKind.POSE, pose));
    menu.push("Add a waypoint here", () -> scene.tools().send(ToolKind.WAYPOINTS, pose));
    menu.push("Look here", () -> scene.go(parts.rig().aim().at(place)));
    menu.push("Measure from here", () -> {
      scene.tools().toggle(ToolKind.MEASURE);
      scene.tools().measure(place);
    });
    menu.push("Copy coordinates",
        () -> Clipboards.copy((Figures.fixed(place.x(), 3) + ' ' + Figures.fixed(place.y(), 3) + ' '
            + Figures.fixed(place.z(), 3)).replace('\u2212', '-')));
  }

  private void waypoints(PopupMenu menu) {
    Waypoints waypoints = parts.waypoints();
    Route route = waypoints.route();
    WaypointKeys keys = new WaypointKeys(scene, parts);
    boolean some = !route.poses().isEmpty();
    menu.check("Place and move (R)", scene.tools().using(ToolKind.WAYPOINTS),
        on -> scene.tools().toggle(ToolKind.WAYPOINTS));
    menu.push(waypoints.tour().driving().isPresent() ? "End the drive (Enter)" : "Drive to all (Enter)", some,
        keys::drive);
    menu.push("Send all as a path", some && parts.sender().takesPath(), () -> scene.say(parts.sender().path(route)));
    menu.push("Send all as poses", some && parts.sender().takesPoses(), () -> scene.say(parts.sender().poses(route)));
    menu.line();
    menu.push("Undo the last change (Ctrl+Z)", keys::undo);
    menu.push("Load from a file\u2026", () -> new WaypointFiles(scene, parts).load());
    menu.push("Save to a file\u2026", some, () -> new WaypointFiles(scene, parts).save());
    menu.push("Copy all as YAML", some, () -> Clipboards.copy(route.yaml()));
    menu.push("Remove all", some, () -> parts.model().soon(waypoints::clear));
  }

  private void cameras(PopupMenu menu) {
    CameraKind now = parts.rig().aim().kind();
    int number = 1;
    for (CameraKind kind : CameraKind.values()) {
      menu.radio(kind.label() + " (" + number++ + ")", kind == now, () -> scene.go(parts.rig().aim().as(kind)));
    }
    follows(menu.under("Follow"));
    menu.line();
    parts.edits().views().forEach((name, pose) -> menu.push(name, () -> scene.go(pose)));
    menu.push("Save this view\u2026", () -> NameDialog.ask(scene.canvas(), "Save this view", "")
        .ifPresent(n -> parts.edits().keep(n, parts.rig().aim())));
    menu.push("Start with this view", () -> parts.edits().keep(Edits.START, parts.rig().aim()));
    if (!parts.edits().views().isEmpty()) {
      PopupMenu forget = menu.under("Delete a saved view");
      parts.edits().views().keySet().forEach(name -> forget.push(name, () -> parts.edits().forget(name)));
    }
  }

  private void follows(PopupMenu menu) {
    String now = parts.settings().current().text(SceneOptions.FOLLOW);
    boolean yaw = parts.settings().current().flag(SceneOptions.FOLLOW_YAW);
    menu.radio("Nothing", now.isBlank(), () -> parts.edits().follow("", yaw));
    names().forEach(name -> menu.radio(name, name.equals(now), () -> parts.edits().follow(name, yaw)));
    menu.line();
    menu.check("Turn with it", yaw, on -> parts.edits().follow(now, on));
  }

  private void fixed(PopupMenu menu) {
    String chosen = parts.settings().current().text(SceneOptions.FIXED_FRAME);
    menu.radio("Automatic", chosen.equals(SceneOptions.AUTO), () -> parts.edits().fixedFrame(SceneOptions.AUTO));
    names().forEach(name -> menu.radio(name, chosen.equals(name), () -> parts.edits().fixedFrame(name)));
  }

  private List<String> names() {
    List<FrameId> frames = parts.model().stage().frames();
    boolean several = frames.stream().map(FrameId::robot).distinct().count() > 1;
    return frames.stream().limit(MOST_FRAMES).map(f -> several ? f.toString() : f.name()).toList();
  }
}
