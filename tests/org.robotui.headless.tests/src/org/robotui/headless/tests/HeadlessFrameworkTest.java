package org.robotui.headless.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.osgi.framework.Bundle;
import org.osgi.framework.FrameworkUtil;

/** Runs in a framework that holds the features of the headless product and nothing else. */
class HeadlessFrameworkTest {

    @Test
    void holdsTheHeadlessApplicationAndTheRosComponent() {
        List<String> names = bundles().map(Bundle::getSymbolicName).toList();

        assertTrue(names.contains("org.robotui.headless"), () -> names.toString());
        assertTrue(names.contains("org.robotui.rfic.ros"), () -> names.toString());
    }

    @Test
    void holdsNoSwtAndNoWorkbench() {
        List<String> windows = bundles().map(Bundle::getSymbolicName)
                .filter(name -> name.matches("org\\.eclipse\\.(swt|jface|ui|e4)(\\..*)?"))
                .toList();

        assertEquals(List.of(), windows);
    }

    @Test
    void resolvesEveryBundleOfOurs() {
        List<String> unresolved = bundles()
                .filter(bundle -> bundle.getSymbolicName().startsWith("org.robotui."))
                .filter(bundle -> bundle.getState() == Bundle.INSTALLED)
                .map(Bundle::toString)
                .toList();

        assertEquals(List.of(), unresolved);
    }

    private static Stream<Bundle> bundles() {
        return Arrays.stream(FrameworkUtil.getBundle(HeadlessFrameworkTest.class).getBundleContext().getBundles());
    }
}
