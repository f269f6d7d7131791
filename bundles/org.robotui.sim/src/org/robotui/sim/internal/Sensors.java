package org.robotui.sim.internal;

import org.robotui.sim.internal.sensor.LaserScanner;
import org.robotui.sim.internal.sensor.SatelliteReceiver;
import org.robotui.sim.internal.sensor.SonarRing;

/** What the robot's sensors measure. All who ask for a scan of the same step get the same. For the stepping thread. */
public final class Sensors {
  private final Simulation simulation;
  private final LaserScanner laser;
  private final SonarRing sonars;
  private final SatelliteReceiver satellites;
  private final Rate scans;
  private float[] scan = {};
  private long scanned;

  public Sensors(Simulation simulation) {
    this.simulation = simulation;
    laser = new LaserScanner(simulation::present, simulation.settings().laser(), simulation.random(10));
    sonars = new SonarRing(simulation::present, simulation.settings().robot().sonars(), simulation.random(11));
    satellites = new SatelliteReceiver(simulation.random(12));
    scans = new Rate(simulation.settings().laser().frequency());
  }

  public boolean isScanDue(long step) {
    return scans.isDue(step);
  }

  /** The ranges of the scan made with a step, in metres from the right to the left, infinite where there is no echo. */
  public float[] scan(long step) {
    if (scanned != step) {
      scan = laser.scan(simulation.state().truth());
      scanned = step;
    }
    return scan.clone();
  }

  /** What one sonar measures now, metres; infinite without an echo. */
  public double sonar(int index) {
    return sonars.measure(simulation.state().truth(), index);
  }

  /** What the satellite receiver measures now. */
  public SatelliteReceiver.Fix fix() {
    return satellites.measure(simulation.state().truth());
  }
}
