package org.robotui.core.internal.host;

import org.robotui.core.internal.config.model.ConfigSource;
import org.robotui.core.internal.config.model.OverlayFile;
import org.robotui.core.internal.config.model.SettingsCheck;
import org.robotui.core.internal.life.Registry;
import org.robotui.core.internal.time.NanoClock;
import org.robotui.core.internal.time.WallClock;
import org.robotui.core.internal.watch.BundleNames;

/**
 * What a core is made of.
 *
 * @param registry the component types
 * @param configs reads configurations
 * @param check checks settings
 * @param overlays reads and writes what users changed
 * @param state where that is kept
 * @param bundles names bundles
 * @param clock monotonic
 * @param wall this machine's
 */
public record CoreParts(
    Registry registry,
    ConfigSource configs,
    SettingsCheck check,
    OverlayFile overlays,
    StateFolder state,
    BundleNames bundles,
    NanoClock clock,
    WallClock wall) {}
