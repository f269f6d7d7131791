package org.robotui.install.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.eclipse.core.runtime.IStatus;
import org.eclipse.core.runtime.MultiStatus;
import org.eclipse.core.runtime.Status;
import org.eclipse.equinox.p2.core.ProvisionException;
import org.junit.jupiter.api.Test;

final class DamageTest {
  private static IStatus within(IStatus... parts) {
    return new MultiStatus("test", 0, parts, "An error occurred while collecting items to be installed", null);
  }

  @Test
  void aSumThatDiffersIsFoundWhereverItIsSaid() {
    IStatus sum = new Status(IStatus.ERROR, "test", ProvisionException.ARTIFACT_MD5_NOT_MATCH,
        "Problems downloading artifact: osgi.bundle,org.example.lidar,1.0.0.sample.", null);

    String sentence = Damage.in(within(within(sum))).orElseThrow();

    assertTrue(sentence.startsWith("org.example.lidar 1.0.0.sample is not what the site has announced"), sentence);
  }

  @Test
  void whatElseFailsIsNoDamage() {
    assertEquals(Optional.empty(), Damage.in(within(Status.error("No space left on device"))));
  }
}
