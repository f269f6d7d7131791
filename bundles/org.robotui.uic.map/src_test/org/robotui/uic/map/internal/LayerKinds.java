package org.robotui.uic.map.internal;

import java.util.List;
import org.robotui.entity.bumper.internal.layer.BumperLayerType;
import org.robotui.entity.grid.internal.layer.GridLayerType;
import org.robotui.entity.gridmap.internal.layer.GridMapLayerType;
import org.robotui.entity.laserscan.internal.layer.LaserScanLayerType;
import org.robotui.entity.odometry.internal.layer.OdometryLayerType;
import org.robotui.entity.path.internal.layer.PathLayerType;
import org.robotui.entity.robot.internal.layer.PoseLayerType;
import org.robotui.entity.robot.internal.layer.RobotLayerType;
import org.robotui.entity.sonar.internal.layer.SonarLayerType;
import org.robotui.ui.layer.LayerType;

/** The kinds of layers that a product brings into maps. */
public final class LayerKinds {
  /** All of them. */
  public static final List<LayerType> ALL = List.of(new GridLayerType(), new GridMapLayerType(), new SonarLayerType(),
      new LaserScanLayerType(),
      new OdometryLayerType(), new PathLayerType(), new PoseLayerType(), new RobotLayerType(), new BumperLayerType());

  private LayerKinds() {}
}
