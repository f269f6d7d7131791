/**
 * What robot interfaces have in common that are one session after another: {@link org.robotui.api.session.SessionRfic}
 * opens a session, follows it on a thread of its own, tells the link why it ended, opens the next one some time later,
 * and ends all of it in a bounded time. A new robot interface gives a {@link org.robotui.api.session.SessionFactory};
 * its sessions offer ports and report the link. {@link org.robotui.api.session.PlacedFrames} and
 * {@link org.robotui.api.session.BaseDriving} are for frameworks without transforms, and for bases.
 */
@org.osgi.annotation.versioning.Version("1.1.0")
package org.robotui.api.session;
