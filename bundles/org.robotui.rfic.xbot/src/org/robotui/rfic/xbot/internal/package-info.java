/**
 * A client of the real-time control of this machine: what it says becomes data, what users want becomes references and
 * verbs.
 */
package org.robotui.rfic.xbot.internal;
