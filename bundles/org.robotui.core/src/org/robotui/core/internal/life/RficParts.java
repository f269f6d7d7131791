package org.robotui.core.internal.life;

import java.util.concurrent.Executor;
import java.util.concurrent.ScheduledExecutorService;
import java.util.function.Supplier;
import org.robotui.core.internal.command.Arbiter;
import org.robotui.core.internal.command.Sender;
import org.robotui.core.internal.port.CallPool;
import org.robotui.core.internal.port.Link;
import org.robotui.core.internal.time.Ageing;
import org.robotui.core.internal.time.NanoClock;
import org.robotui.core.internal.time.StampWatch;

/**
 * What the ports of one robot interface are made of.
 *
 * @param component its id
 * @param link its link
 * @param arbiter of its robot
 * @param sender sends its commands
 * @param calls handles its calls that are answered soon
 * @param tasks handles its calls that command the robot and may take long
 * @param timer for time-outs
 * @param background tells it of demand
 * @param clock monotonic
 * @param ages the time by which its values grow old
 * @param stamps notices that the time of the robot jumped back
 * @param changed is told that the offers have changed
 * @param origin names its bundle and class
 */
record RficParts(
    String component,
    Link link,
    Arbiter arbiter,
    Sender sender,
    CallPool calls,
    CallPool tasks,
    ScheduledExecutorService timer,
    Executor background,
    NanoClock clock,
    Ageing ages,
    StampWatch stamps,
    Runnable changed,
    Supplier<String> origin) {}
