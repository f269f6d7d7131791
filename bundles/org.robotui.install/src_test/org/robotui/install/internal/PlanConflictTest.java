package org.robotui.install.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Map;
import java.util.Set;
import org.eclipse.core.runtime.IStatus;
import org.eclipse.core.runtime.MultiStatus;
import org.eclipse.core.runtime.Status;
import org.eclipse.equinox.internal.p2.director.Explanation;
import org.eclipse.equinox.internal.provisional.p2.director.PlannerStatus;
import org.eclipse.equinox.internal.provisional.p2.director.RequestStatus;
import org.eclipse.equinox.p2.metadata.IInstallableUnit;
import org.eclipse.equinox.p2.metadata.IRequirement;
import org.eclipse.equinox.p2.metadata.MetadataFactory;
import org.eclipse.equinox.p2.metadata.MetadataFactory.InstallableUnitDescription;
import org.eclipse.equinox.p2.metadata.Version;
import org.eclipse.equinox.p2.metadata.VersionRange;
import org.junit.jupiter.api.Test;

@SuppressWarnings("restriction") // p2 tells reasons as values in packages of its own only
final class PlanConflictTest {
  private static IInstallableUnit unit(String id, String version, String name) {
    InstallableUnitDescription unit = new InstallableUnitDescription();
    unit.setId(id);
    unit.setVersion(Version.create(version));
    unit.setProperty(IInstallableUnit.PROP_NAME, name);
    return MetadataFactory.createInstallableUnit(unit);
  }

  private static IStatus conflict(Explanation... reasons) {
    RequestStatus request = new RequestStatus(null, RequestStatus.ADDED, IStatus.ERROR, Set.of(reasons));
    return new PlannerStatus(Status.error("cannot be"), request, Map.of(), Map.of(), null);
  }

  private static String missing(String namespace, String name, String range) {
    IRequirement requirement =
        MetadataFactory.createRequirement(namespace, name, new VersionRange(range), null, false, false);
    return PlanConflict
        .sentence(
            conflict(new Explanation.MissingIU(unit("lidar.feature.group", "1.0.0", "Lidar"), requirement, false)));
  }

  @Test
  void whatIsMissingIsNamedWithWhoNeedsIt() {
    String end = ", which is neither on the site nor installed.";

    assertEquals("Lidar 1.0.0 needs the package org.example.base 1.0.0 or newer, but older than 2.0.0" + end,
        missing("java.package", "org.example.base", "[1.0.0,2.0.0)"));
    assertEquals("Lidar 1.0.0 needs the bundle org.example.base 1.2.3" + end,
        missing("osgi.bundle", "org.example.base", "[1.2.3,1.2.3]"));
    assertEquals("Lidar 1.0.0 needs sonar" + end,
        missing("org.eclipse.equinox.p2.iu", "sonar.feature.group", "0.0.0"));
  }

  @Test
  void twoThatExcludeOneAnotherAreNamed() {
    Explanation both = new Explanation.Singleton(
        new IInstallableUnit[]{unit("a", "1.0.0", "Lidar"), unit("a", "2.0.0", null)});

    assertEquals("Only one of Lidar 1.0.0 and a 2.0.0 can be installed.", PlanConflict.sentence(conflict(both)));
  }

  @Test
  void whereNoReasonIsKnownThatWhichIsSaidMostCloselyIsPassedOn() {
    IStatus inner = new MultiStatus("test", 0, new IStatus[]{Status.error("No space left on device")}, "Failed", null);

    assertEquals("No space left on device.", PlanConflict.sentence(inner));
  }
}
