package org.robotui.testkit.host;

import java.time.Duration;
import java.util.Optional;
import org.robotui.api.time.RobotClock;
import org.robotui.data.ClockKind;
import org.robotui.data.Stamp;

/**
 * A clock that stands.
 *
 * @param now the time
 * @param kind whose clock it is
 * @param offset how far it is ahead of ours
 * @param epoch how often it jumped back
 */
public record FakeClock(Stamp now, ClockKind kind, Optional<Duration> offset, long epoch) implements RobotClock {}
