/**
 * A client of the real-time side ({@code rt-native}), usable alone: it finds a running control by its robot's name,
 * maps the memory in which it publishes its state, and asks its supervisor. Nothing here can disturb the control: the
 * memory is read only, and the supervisor is no part of the control's cycle.
 */
@org.osgi.annotation.versioning.Version("1.3.0")
package org.robotui.xbot;
