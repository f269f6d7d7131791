/** Communication objects as data types: lengths of SmartSoft are in mm. */
package org.robotui.rfic.smartsoft.internal.convert;
