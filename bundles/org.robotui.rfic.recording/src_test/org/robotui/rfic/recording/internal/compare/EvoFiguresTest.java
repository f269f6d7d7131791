package org.robotui.rfic.recording.internal.compare;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/**
 * Errors of ways are those of evo. The figures were computed once by evo 1.38.1 from PyPI, for the two ways that are
 * made here: {@code sync.associate_trajectories}, {@code PoseTrajectory3D.align} or {@code align_origin}, then
 * {@code APE} and {@code RPE} with {@code all_pairs=False} and the relations {@code translation_part} and
 * {@code rotation_angle_deg}.
 */
class EvoFiguresTest {
  private static final int COUNT = 120;
  private static final RigidTransform MOVED =
      new RigidTransform(new Vector3(1.5, -2, 0.3), Quaternion.fromRollPitchYaw(0.05, -0.1, 0.7));

  private static RigidTransform pose(double s) {
    return new RigidTransform(
        new Vector3(2 * Math.cos(0.5 * s), 3 * Math.sin(0.7 * s), 0.2 * Math.sin(1.3 * s)),
        Quaternion.fromRollPitchYaw(0.1 * Math.sin(s), 0.05 * Math.cos(2 * s), 0.4 * s));
  }

  private static RecordedWay first() {
    return new RecordedWay(IntStream.range(0, COUNT).mapToLong(i -> Math.round(0.1 * i * 1e9)).toArray(),
        IntStream.range(0, COUNT).mapToObj(i -> pose(0.1 * i)).toList());
  }

  /** The same way, elsewhere, with errors, at other times, and with a seventh of the poses missing. */
  private static RecordedWay second() {
    List<Long> times = new ArrayList<>();
    List<RigidTransform> poses = new ArrayList<>();
    for (int i = 0; i < COUNT; i++) {
      if (i % 7 != 3) {
        double s = 0.1 * i;
        RigidTransform right = pose(s);
        Vector3 off = new Vector3(0.02 * Math.sin(3 * s), 0.03 * Math.cos(2 * s), 0.01 * Math.sin(5 * s));
        Quaternion turn = Quaternion.fromRollPitchYaw(0.01 * Math.sin(4 * s), 0.02 * Math.cos(s),
            0.03 * Math.sin(2 * s) + 0.002 * s);
        times.add(Math.round((s + 0.003 * Math.sin(i)) * 1e9));
        poses.add(MOVED.times(new RigidTransform(right.translation().plus(off), right.rotation().times(turn))));
      }
    }
    return new RecordedWay(times.stream().mapToLong(Long::longValue).toArray(), poses);
  }

  @ParameterizedTest
  @CsvSource({
      "NONE, 1, APE position, 103, 3.054007280, 2.868039170, 2.595170786, 1.049434031, 1.182186879, 4.648616643",
      "NONE, 1, APE rotation, 103, 41.476046861, 41.458041935, 41.447659310, 1.221974673, 39.371367519, 43.551133972",
      "ORIGIN, 1, APE position, 103, 0.064580385, 0.060444994, 0.059178108, 0.022738270, 0, 0.100483742",
      "ORIGIN, 1, APE rotation, 103, 2.019662709, 1.882913614, 1.892657524, 0.730529794, 0, 3.122057921",
      "SE3, 1, APE position, 103, 0.026295231, 0.025311896, 0.026238266, 0.007123701, 0.013769342, 0.036750959",
      "SE3, 1, APE rotation, 103, 1.693523010, 1.555074751, 1.409211056, 0.670643500, 0.132667916, 3.023712259",
      "SE3, 1, RPE position per pose, 102, 0.009142739, 0.008048465, 0.007190990, 0.004337268, 0.000990048, 0.032279301",
      "SE3, 1, RPE rotation per pose, 102, 0.384345875, 0.356544713, 0.303716320, 0.143518706, 0.207033445, 0.915069974",
      "SE3, 10, RPE position per 10 poses, 10, 0.056376534, 0.053303245, 0.054818103, 0.018359674, 0.018090677, "
          + "0.078994925",
      "SE3, 10, RPE rotation per 10 poses, 10, 2.545757699, 2.424153243, 2.496099769, 0.777408077, 1.149935142, "
          + "3.362575290",
      "SE3, 0.5m, RPE position per 0.5 m, 27, 0.029036384, 0.026298819, 0.023711685, 0.012307871, 0.009032821, "
          + "0.060498433",
      "SE3, 0.5m, RPE rotation per 0.5 m, 27, 1.246064090, 1.173448803, 1.094125979, 0.419158232, 0.640227969, "
          + "2.210976451"})
  void are_those_of_evo(PoseFit fit, String step, String name, int count, double rmse, double mean, double median,
      double deviation, double least, double most) throws CompareException {
    PosePairs pairs = PosePairs.nearest(first(), second(), 0, CompareWish.MOST_APART);
    ErrorSeries errors = pairs.aligned(fit).errors(RelativeStep.of(step)).stream()
        .filter(each -> each.name().equals(name)).findFirst().orElseThrow();
    ErrorFigures figures = errors.figures();
    assertEquals(count, figures.count());
    assertEquals(rmse, figures.rmse(), 2e-7);
    assertEquals(mean, figures.mean(), 2e-7);
    assertEquals(median, figures.median(), 2e-7);
    assertEquals(deviation, figures.deviation(), 2e-7);
    assertEquals(least, figures.least(), 2e-6);
    assertEquals(most, figures.most(), 2e-7);
    assertEquals(count, errors.times().length);
  }

  @Test
  void are_the_same_whichever_way_has_more_poses() throws CompareException {
    PosePairs there = PosePairs.nearest(first(), second(), 5_000_000_000L, CompareWish.MOST_APART);
    PosePairs back = PosePairs.nearest(second(), first(), -5_000_000_000L, CompareWish.MOST_APART);
    assertTrue(there.times().size() > 40, there.times().size() + " pairs");
    assertEquals(there.first(), back.second());
    assertEquals(there.second(), back.first());
  }

  @Test
  void a_level_alignment_turns_around_the_vertical_axis_alone() throws CompareException {
    List<RigidTransform> flat = IntStream.range(0, 50)
        .mapToObj(i -> RigidTransform.planar(Math.cos(0.1 * i), 2 * Math.sin(0.13 * i), 0.1 * i)).toList();
    RigidTransform turn = RigidTransform.planar(4, -3, 2.5);
    List<RigidTransform> turned = flat.stream().map(turn::times).toList();
    for (PoseFit fit : List.of(PoseFit.YAW, PoseFit.SE3)) {
      RigidTransform found = fit.of(turned, flat);
      assertEquals(0, found.times(turn).translation().norm(), 1e-9, fit.word());
      assertEquals(1, Math.abs(found.times(turn).rotation().w()), 1e-12, fit.word());
    }
    List<RigidTransform> tilted = flat.stream().map(MOVED::times).toList();
    RigidTransform level = PoseFit.YAW.of(tilted, flat);
    assertEquals(0, level.rotation().x(), 1e-12);
    assertEquals(0, level.rotation().y(), 1e-12);
    double best = distances(tilted, flat, level);
    for (double off : new double[]{-0.01, 0.01}) {
      assertTrue(distances(tilted, flat, level.times(RigidTransform.planar(0, 0, off))) > best);
      assertTrue(distances(tilted, flat, RigidTransform.planar(off, 0, 0).times(level)) > best);
    }
  }

  private static double distances(List<RigidTransform> moved, List<RigidTransform> fixed, RigidTransform by) {
    return IntStream.range(0, moved.size()).mapToDouble(i -> by.apply(moved.get(i).translation())
        .minus(fixed.get(i).translation()).norm()).map(each -> each * each).sum();
  }

  @Test
  void say_where_no_turn_fits_best() {
    List<RigidTransform> line = IntStream.range(0, 20).mapToObj(i -> RigidTransform.planar(i, 2 * i, 0)).toList();
    CompareException refused = assertThrows(CompareException.class, () -> PoseFit.SE3.of(line, line));
    assertTrue(refused.getMessage().contains("align by yaw"), refused.getMessage());
  }

  @Test
  void are_paired_by_the_way_gone() throws CompareException {
    RecordedWay slow = new RecordedWay(IntStream.range(0, 101).mapToLong(i -> i * 100L).toArray(),
        IntStream.range(0, 101).mapToObj(i -> RigidTransform.planar(0.1 * i, 0, 0)).toList());
    // twice as fast, with a rest in the middle
    RecordedWay fast = new RecordedWay(IntStream.range(0, 71).mapToLong(i -> i * 100L).toArray(),
        IntStream.range(0, 71).mapToObj(i -> RigidTransform.planar(0.2 * (i < 25 ? i : Math.max(25, i - 20)), 0.5, 0))
            .toList());
    PosePairs pairs = PosePairs.mapped(slow, fast, time -> fast.timeOf(slow.goneAt(time)));
    assertEquals(101, pairs.times().size());
    for (ErrorSeries each : pairs.aligned(PoseFit.NONE).errors(RelativeStep.POSE)) {
      assertEquals(each.name().equals("APE position") ? 0.5 : 0, each.figures().most(), 1e-9, each.name());
    }
  }
}
