package org.robotui.uic.map.internal.model;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.robotui.api.UicContext;
import org.robotui.api.port.Input;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.ui.scene.PastSpot;
import org.robotui.ui.scene.PastWays;
import org.robotui.ui.scene.Placer;
import org.robotui.uic.map.internal.MapPorts;

/**
 * Where recorded robots were at the time at which the user points: by odometry, else by an estimate. The frames of both
 * are where they are now, as for trails. Worker thread.
 */
final class PastPlaces {
  private final Input<Odometry> odometry;
  private final Input<PoseEstimate> poses;
  private final PastWays driven;
  private final PastWays estimated;
  private final Team team;

  PastPlaces(UicContext context, Team team) {
    odometry = context.input(MapPorts.ODOM);
    poses = context.input(MapPorts.POSE);
    driven = new PastWays(context.pointed(), context.background());
    estimated = new PastWays(context.pointed(), context.background());
    this.team = team;
  }

  List<PastPlace> find(Placer placer) {
    Map<String, PastSpot> spots = new LinkedHashMap<>(driven.spots(odometry, odometry.sources()));
    estimated.spots(poses, poses.sources()).forEach(spots::putIfAbsent);
    return spots.entrySet().stream().flatMap(each -> placer.latest(each.getValue().frame()).found().stream()
        .map(fixedFromFrame -> new PastPlace(each.getValue(), fixedFromFrame, team.number(each.getKey())))).toList();
  }
}
