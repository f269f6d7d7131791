package org.robotui.uic.scene3d.internal;

import java.util.List;
import java.util.concurrent.Executor;
import java.util.function.Supplier;
import org.robotui.api.config.SettingsStore;
import org.robotui.gl.display.DisplayType;
import org.robotui.ui.scene.Commander;
import org.robotui.uic.scene3d.internal.camera.CameraMotion;
import org.robotui.uic.scene3d.internal.model.Edits;
import org.robotui.uic.scene3d.internal.model.Picks;
import org.robotui.uic.scene3d.internal.model.SceneModel;
import org.robotui.uic.scene3d.internal.render.FrameScheduler;
import org.robotui.uic.scene3d.internal.waypoint.WaypointSender;
import org.robotui.uic.scene3d.internal.waypoint.Waypoints;

/**
 * What a scene consists of.
 *
 * @param model the displays
 * @param studio the pictures
 * @param rig the camera
 * @param picks what is selected
 * @param edits what the user changes
 * @param commander sends goals and poses
 * @param waypoints places to go to
 * @param sender sends the waypoints as a list
 * @param settings as chosen
 * @param kinds of displays that are there
 * @param background for files
 */
public record SceneParts(SceneModel model, FrameScheduler studio, CameraMotion rig, Picks picks, Edits edits,
    Commander commander, Waypoints waypoints,
    WaypointSender sender, SettingsStore settings, Supplier<List<DisplayType>> kinds, Executor background) {}
